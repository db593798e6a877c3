// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/core/parallel.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <stdexcept>
#include <thread>

#include <doctest/doctest.h>

using namespace wm3d;

TEST_CASE("every number is visited once, whatever the block") {
    for (std::size_t block : {1u, 3u, 7u, 100u, 1000u}) {
        std::vector<int> visits(100, 0);
        parallel_blocks(visits.size(), block, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                ++visits[i];
        });
        CHECK(visits == std::vector<int>(100, 1));
    }
    parallel_blocks(0, 8, [](std::size_t, std::size_t) { FAIL("no block is expected"); });
}

TEST_CASE("shares are one after the other, and but one where the list is short") {
    for (const std::size_t length : {std::size_t{10}, std::size_t{1} << 22}) {
        std::vector<int> visits(1001, 0);
        std::atomic<std::size_t> shares = 0;
        parallel_shares(visits.size(), length, [&](std::size_t begin, std::size_t end) {
            ++shares;
            for (std::size_t i = begin; i < end; ++i)
                ++visits[i];
        });
        CHECK(visits == std::vector<int>(1001, 1));
        CHECK(shares == (length == 10 ? 1 : std::min<std::size_t>(8, thread_count())));
    }
    parallel_shares(0, 1u << 22, [](std::size_t, std::size_t) { FAIL("no share is expected"); });
}

TEST_CASE("a sum has the same bits at one thread and at many") {
    const auto sum = [] {
        return parallel_sum(100000, 512, 0.0, [](std::size_t begin, std::size_t end) {
            double s = 0;
            for (std::size_t i = begin; i < end; ++i)
                s += std::sin(static_cast<double>(i));
            return s;
        });
    };
    const double many = sum();
    const ThreadLimit one(1);
    CHECK(thread_count() == 1);
    CHECK(sum() == many);
}

TEST_CASE("a sum of terms is that of the blocks' own sums") {
    const auto term = [](std::size_t i) { return std::sin(static_cast<double>(i)); };
    double sum = 0;
    for (std::size_t begin = 0; begin < 1000; begin += 300) {
        double part = 0;
        for (std::size_t i = begin; i < std::min<std::size_t>(begin + 300, 1000); ++i)
            part += term(i);
        sum += part;
    }
    CHECK(parallel_sum_of(1000, 300, term) == sum);
    CHECK(parallel_sum_of(0, 300, term) == 0);
}

TEST_CASE("an exception in a block reaches the caller") {
    CHECK_THROWS_AS(parallel_blocks(100, 1,
                                    [](std::size_t begin, std::size_t) {
                                        if (begin == 50)
                                            throw std::runtime_error("block 50");
                                    }),
                    std::runtime_error);
}

TEST_CASE("a task with a loop of its own never starts inside another") {
    std::vector<int> visits(50, 0);
    std::atomic<int> nested = 0;
    static thread_local bool inside = false;
    parallel_tasks(visits.size(), [&](std::size_t i) {
        nested += inside;
        inside = true;
        parallel_blocks(64, 1, [&](std::size_t, std::size_t) {
            volatile double x = 0;
            for (int k = 0; k < 2000; ++k)
                x = x + k;
        });
        inside = false;
        ++visits[i];
    });
    CHECK(visits == std::vector<int>(50, 1));
    CHECK(nested == 0);
}

TEST_CASE("an exception in a task reaches the caller") {
    CHECK_THROWS_AS(parallel_tasks(10,
                                   [](std::size_t i) {
                                       if (i == 5)
                                           throw std::runtime_error("task 5");
                                   }),
                    std::runtime_error);
}

TEST_CASE("a task that throws leaves the loops of others whole") {
    std::atomic<int> begun{0}, cut_short{0};
    std::atomic<bool> thrown{false};
    const auto task = [&](std::size_t) {
        if (begun++ == 1) { // the first is at work then, if there are two threads
            thrown = true;
            throw std::runtime_error("one of the tasks");
        }
        std::atomic<int> done{0};
        parallel_blocks(4000, 1, [&](std::size_t, std::size_t) {
            volatile double x = 1;
            for (int i = 0; i < 500; ++i)
                x = std::sqrt(x + i);
            ++done;
        });
        cut_short += done != 4000;
    };
    CHECK_THROWS_AS(parallel_tasks(64, task), std::runtime_error);
    CHECK(thrown);
    CHECK(cut_short == 0);
}

TEST_CASE("both tasks run") {
    std::atomic<int> done = 0;
    parallel_invoke([&] { done += 1; }, [&] { done += 2; });
    CHECK(done == 3);
}

TEST_CASE("of two tasks the second runs on the calling thread, which hears signals and calls back") {
    const std::thread::id here = std::this_thread::get_id();
    for (int k = 0; k < 200; ++k) {
        std::atomic<int> done = 0;
        parallel_invoke([&] { ++done; }, [&] { done += std::this_thread::get_id() == here ? 10 : 100; });
        REQUIRE(done == 11);
    }
}
