// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Threads. Work is cut into blocks whose borders depend on the problem alone and partial results
/// are combined in block order, so every result has the same bytes at any number of threads.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace wm3d {

/// Limits the threads that wm3d uses while the object lives; 0 means as many as the machine has.
class ThreadLimit {
public:
    explicit ThreadLimit(std::size_t threads);
    ~ThreadLimit();
    ThreadLimit(const ThreadLimit&) = delete;
    ThreadLimit& operator=(const ThreadLimit&) = delete;

private:
    struct Control;
    Control* control_;
};

/// Number of threads that parallel loops use now.
std::size_t thread_count();

/// Calls body(begin, end) for every block of `block` consecutive numbers of [0, count); the last may be
/// shorter. Blocks run in any order and at the same time: they must write to places of their own.
/// An exception in a block reaches the caller.
/// \pre  block > 0
void parallel_blocks(std::size_t count, std::size_t block,
                     const std::function<void(std::size_t begin, std::size_t end)>& body);

/// Calls body(i) for every i of [0, count), started in that order: for long tasks with parallel loops of
/// their own. A thread that waits for such a loop takes no other task meanwhile, so no more of them are begun
/// than there are threads. An exception in a task reaches the caller.
void parallel_tasks(std::size_t count, const std::function<void(std::size_t i)>& body);

/// Calls body(begin, end) for a few consecutive ranges that together are [0, count), at the same time: for passes over a
/// whole list of `length` entries, each of which keeps what falls into its own range, in the list's order. One range
/// where the list is short. What comes of it must not depend on where ranges end.
void parallel_shares(std::size_t count, std::size_t length,
                     const std::function<void(std::size_t begin, std::size_t end)>& body);

/// Runs two independent tasks, at the same time if a thread is free; the second on the calling thread.
void parallel_invoke(const std::function<void()>& first, const std::function<void()>& second);

/// Sum over blocks of [0, count), added in block order. `term(begin, end)` returns the block's own sum.
template<typename T, typename Term>
T parallel_sum(std::size_t count, std::size_t block, T zero, Term&& term) {
    std::vector<T> partial((count + block - 1) / block, zero);
    parallel_blocks(count, block,
                    [&](std::size_t begin, std::size_t end) { partial[begin / block] = term(begin, end); });
    T sum = zero;
    for (const T& part : partial)
        sum += part;
    return sum;
}

/// Sum of term(i) over [0, count), in blocks as above.
template<typename Term>
double parallel_sum_of(std::size_t count, std::size_t block, Term&& term) {
    return parallel_sum(count, block, 0.0, [&](std::size_t begin, std::size_t end) {
        double part = 0;
        for (std::size_t i = begin; i < end; ++i)
            part += term(i);
        return part;
    });
}

} // namespace wm3d
