// SPDX-License-Identifier: GPL-3.0-or-later
// parallel.cpp for the thread sanitizer, which does not see how TBB's threads wait for each other and would
// call everything that they share a race: plain threads, begun and joined in every call.
#include <wm3d/core/parallel.hpp>

#include <algorithm>
#include <atomic>
#include <exception>
#include <future>
#include <mutex>
#include <thread>
#include <vector>

namespace wm3d {

namespace {

std::atomic<std::size_t> limit{std::max(2u, std::thread::hardware_concurrency())};

/// Calls body(0) .. body(count - 1) from several threads and throws on what the first that fails throws.
void run(std::size_t count, const std::function<void(std::size_t)>& body) {
    std::atomic<std::size_t> next{0};
    std::exception_ptr failed;
    std::mutex guard;
    const auto work = [&] {
        for (std::size_t i = next++; i < count; i = next++) {
            try {
                body(i);
            } catch (...) {
                const std::lock_guard lock(guard);
                if (!failed)
                    failed = std::current_exception();
            }
        }
    };
    std::vector<std::thread> threads;
    while (threads.size() + 1 < std::min<std::size_t>(limit, count))
        threads.emplace_back(work);
    work();
    for (std::thread& thread : threads)
        thread.join();
    if (failed)
        std::rethrow_exception(failed);
}

} // namespace

struct ThreadLimit::Control {
    std::size_t before;
};

ThreadLimit::ThreadLimit(std::size_t threads)
    : control_(threads == 0 ? nullptr : new Control{limit.exchange(threads)}) {}

ThreadLimit::~ThreadLimit() {
    if (control_ != nullptr)
        limit = control_->before;
    delete control_;
}

std::size_t thread_count() {
    return limit;
}

void parallel_blocks(std::size_t count, std::size_t block,
                     const std::function<void(std::size_t, std::size_t)>& body) {
    const std::size_t blocks = (count + block - 1) / block;
    run(blocks, [&](std::size_t b) { body(b * block, std::min(count, (b + 1) * block)); });
}

void parallel_tasks(std::size_t count, const std::function<void(std::size_t)>& body) {
    run(count, body);
}

void parallel_invoke(const std::function<void()>& first, const std::function<void()>& second) {
    std::future<void> other = std::async(limit < 2 ? std::launch::deferred : std::launch::async, first);
    second();
    other.get();
}

} // namespace wm3d
