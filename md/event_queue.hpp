// SPDX-License-Identifier: MIT
// Which owner's event comes first. Every owner (0 .. N-1) has exactly one event; scheduling replaces it in O(1).
// A bounded calendar: buckets of equal width hold unsorted linked lists, the bucket in use is a small heap
// (Paul 2007, J. Comput. Phys. 221, 615). Events after the horizon are parked until the next reset.
// The order is (time, owner): a total one, so it depends neither on the bucket width nor on the history of the queue.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "md/paged_vector.hpp"

namespace shaken::md {

struct QueuedEvent {
    double time;
    std::uint32_t owner;
};

/// What an event is about, in the words of whoever schedules it; kept beside its time.
struct EventSubject {
    std::uint32_t partner = 0, stamp = 0;
};

class EventQueue {
  public:
    explicit EventQueue(std::size_t owners);

    /// Forgets all events; those scheduled from now on are expected in [start, horizon], about `expected` of them.
    void reset(double start, double horizon, double expected);

    /// Sets the owner's event. A time before the last one popped is legal and comes first.
    void schedule(std::uint32_t owner, double time, EventSubject subject = {}) {
        unlink(owner);
        Node& node = nodes_[owner];
        node.time = time;
        node.subject = subject;
        if (!(time <= horizon_)) {
            node.previous = parked;
            return;
        }
        const std::int64_t bucket = bucket_of(time);
        if (bucket <= current_) {
            node.previous = in_heap;
            push({time, owner});
        } else {
            link(owner, bucket);
        }
    }

    /// The first event, left in the queue; time is `infinity` when all are parked. Its owner must be scheduled anew
    /// once the event has been dealt with: that takes it out.
    QueuedEvent front();

    double time(std::uint32_t owner) const { return nodes_[owner].time; }
    EventSubject subject(std::uint32_t owner) const { return nodes_[owner].subject; }
    std::size_t owners() const { return nodes_.size(); }
    std::size_t bytes() const;

  private:
    struct alignas(32) Node {  // never in two cache lines
        double time;
        std::uint32_t next, previous;
        EventSubject subject;
    };
    static constexpr std::uint32_t end = 0xffffffffu, in_heap = 0xfffffffeu, parked = 0xfffffffdu;

    std::int64_t bucket_of(double time) const { return static_cast<std::int64_t>((time - start_) * buckets_per_time_); }
    std::uint32_t& head(std::int64_t bucket) { return heads_[static_cast<std::size_t>(bucket) & mask_]; }

    void link(std::uint32_t owner, std::int64_t bucket) {
        std::uint32_t& first = head(bucket);
        nodes_[owner].next = first;
        nodes_[owner].previous = end;
        if (first != end) nodes_[first].previous = owner;
        first = owner;
    }
    void unlink(std::uint32_t owner) {
        const Node& node = nodes_[owner];
        if (node.previous == in_heap || node.previous == parked) return;  // heap entries go stale by themselves
        if (node.previous == end)
            head(bucket_of(node.time)) = node.next;
        else
            nodes_[node.previous].next = node.next;
        if (node.next != end) nodes_[node.next].previous = node.previous;
    }
    void push(QueuedEvent event);
    void pop();
    void open_next_bucket();

    PagedVector<Node> nodes_;
    PagedVector<std::uint32_t> heads_;
    std::vector<QueuedEvent> heap_;  // of the current bucket; smallest first
    std::size_t mask_ = 0;
    double start_ = 0.0, horizon_ = 0.0, buckets_per_time_ = 1.0;
    std::int64_t current_ = 0, last_ = 0;
};

}  // namespace shaken::md
