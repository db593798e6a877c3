// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/core/parallel.hpp>

#include <algorithm>
#include <atomic>

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

namespace wm3d {

namespace {

/// Of the context that a loop runs in. A loop that is part of a task would else be called off, half done and without a
/// word, where another task throws.
constexpr auto its_own = tbb::task_group_context::isolated;

} // namespace

struct ThreadLimit::Control {
    tbb::global_control control;
};

ThreadLimit::ThreadLimit(std::size_t threads)
    : control_(threads == 0 ? nullptr
                            : new Control{{tbb::global_control::max_allowed_parallelism, threads}}) {}

ThreadLimit::~ThreadLimit() {
    delete control_;
}

std::size_t thread_count() {
    return std::min(tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism),
                    static_cast<std::size_t>(tbb::this_task_arena::max_concurrency()));
}

void parallel_blocks(std::size_t count, std::size_t block,
                     const std::function<void(std::size_t, std::size_t)>& body) {
    if (count <= block) { // not worth waking a thread
        if (count > 0)
            body(0, count);
        return;
    }
    const std::size_t blocks = (count + block - 1) / block;
    tbb::task_group_context context(its_own);
    tbb::parallel_for(
        std::size_t{0}, blocks, [&](std::size_t b) { body(b * block, std::min(count, (b + 1) * block)); },
        context);
}

void parallel_tasks(std::size_t count, const std::function<void(std::size_t)>& body) {
    std::atomic<std::size_t> next{0};
    tbb::task_group_context context(its_own);
    tbb::parallel_for(
        std::size_t{0}, count, [&](std::size_t) { tbb::this_task_arena::isolate([&] { body(next++); }); },
        context);
}

void parallel_invoke(const std::function<void()>& first, const std::function<void()>& second) {
    tbb::task_group_context context(its_own);
    tbb::task_group group(context);
    group.run(first);
    group.run_and_wait(second);
}

} // namespace wm3d
