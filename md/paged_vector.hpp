// SPDX-License-Identifier: MIT
// A vector for the engine's large arrays, on pages of 2 MB where the system has them. Events jump all over these
// arrays; on small pages most of the time of a large run goes into looking up addresses (bench/md.md).
#pragma once

#include <cstddef>
#include <cstdlib>
#include <new>
#include <vector>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace shaken::md {

template <class T>
struct PagedAllocator {
    using value_type = T;
    static constexpr std::size_t page = std::size_t{1} << 21;
    static constexpr std::align_val_t line{alignof(T) > 64 ? alignof(T) : 64};  // small arrays begin a cache line

    PagedAllocator() = default;
    template <class U>
    PagedAllocator(const PagedAllocator<U>& /*other*/) {}

    T* allocate(std::size_t count) {
        const std::size_t bytes = count * sizeof(T);
        if (bytes < page / 2) return static_cast<T*>(::operator new (bytes, line));
        const std::size_t whole = (bytes + page - 1) / page * page;
        void* const memory = ::operator new (whole, std::align_val_t{page});
#if defined(__linux__)
        static_cast<void>(::madvise(memory, whole, MADV_HUGEPAGE));  // a wish: without it the array is merely slower
#endif
        return static_cast<T*>(memory);
    }
    void deallocate(T* memory, std::size_t count) {
        const bool large = count * sizeof(T) >= page / 2;
        ::operator delete (memory, large ? std::align_val_t{page} : line);
    }
    bool operator==(const PagedAllocator&) const = default;
};

template <class T>
using PagedVector = std::vector<T, PagedAllocator<T>>;

}  // namespace shaken::md
