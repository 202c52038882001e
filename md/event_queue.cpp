// SPDX-License-Identifier: MIT
#include "md/event_queue.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace shaken::md {

namespace {

/// Orders a heap of the standard library so that the earliest stands in front.
constexpr auto later = [](const QueuedEvent& a, const QueuedEvent& b) {
    return a.time > b.time || (a.time == b.time && a.owner > b.owner);
};

}  // namespace

EventQueue::EventQueue(std::size_t owners) : nodes_(owners, Node{0.0, end, parked, {}}) { reset(0.0, 0.0, 1.0); }

void EventQueue::reset(double start, double horizon, double expected) {
    // A few events a bucket; with as many buckets as owners nearly all that is scheduled fits without a wrap.
    constexpr double events_per_bucket = 2.5;  // found by bench/md.md
    const double buckets = std::clamp(expected / events_per_bucket, 16.0, 1e9);
    const std::size_t held = std::bit_ceil(std::clamp<std::size_t>(nodes_.size(), 1024, std::size_t{1} << 24));
    heads_.assign(held, end);
    mask_ = held - 1;
    start_ = start;
    horizon_ = horizon;
    buckets_per_time_ = horizon > start ? buckets / (horizon - start) : 1.0;
    current_ = 0;
    last_ = bucket_of(horizon);
    heap_.clear();
    for (Node& node : nodes_) node.previous = parked;
}

void EventQueue::push(QueuedEvent event) {
    heap_.push_back(event);
    std::push_heap(heap_.begin(), heap_.end(), later);
}

void EventQueue::pop() {
    std::pop_heap(heap_.begin(), heap_.end(), later);
    heap_.pop_back();
}

void EventQueue::open_next_bucket() {
    ++current_;
    std::uint32_t owner = head(current_);
    while (owner != end) {
        const std::uint32_t following = nodes_[owner].next;
        if (bucket_of(nodes_[owner].time) == current_) {  // else it belongs to a later turn of the wheel
            unlink(owner);
            nodes_[owner].previous = in_heap;
            heap_.push_back({nodes_[owner].time, owner});
        }
        owner = following;
    }
    std::make_heap(heap_.begin(), heap_.end(), later);
}

QueuedEvent EventQueue::front() {
    while (true) {
        while (!heap_.empty()) {
            const QueuedEvent& first = heap_.front();
            const Node& node = nodes_[first.owner];
            if (node.previous == in_heap && node.time == first.time) return first;
            pop();
        }
        if (current_ >= last_) return {std::numeric_limits<double>::infinity(), end};
        open_next_bucket();
    }
}

std::size_t EventQueue::bytes() const {
    return nodes_.capacity() * sizeof(Node) + heads_.capacity() * sizeof(std::uint32_t) +
           heap_.capacity() * sizeof(QueuedEvent);
}

}  // namespace shaken::md
