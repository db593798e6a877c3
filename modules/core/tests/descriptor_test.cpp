// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/core/descriptor.hpp>

#include <array>
#include <cerrno>
#include <string>
#include <thread>

#include <doctest/doctest.h>
#include <fcntl.h>

using namespace wm3d;

TEST_CASE("a descriptor is closed once, by whoever holds it last") {
    std::array<int, 2> ends{};
    REQUIRE(::pipe(ends.data()) == 0);
    const Descriptor out(ends[0]);
    {
        Descriptor first(ends[1]);
        const Descriptor second(std::move(first));
        CHECK_FALSE(first.valid()); // NOLINT(bugprone-use-after-move): that nothing is left is tested
        CHECK(second.get() == ends[1]);
        CHECK(::fcntl(ends[1], F_GETFD) != -1);
    }
    CHECK(::fcntl(ends[1], F_GETFD) == -1);
}

TEST_CASE("all bytes arrive, though a pipe takes them in parts") {
    std::array<int, 2> ends{};
    REQUIRE(::pipe(ends.data()) == 0);
    const Descriptor out(ends[0]);
    Descriptor in(ends[1]);
    const std::string sent(1 << 20, 'x');
    std::string got;
    std::thread reader([&] {
        std::array<char, 4096> block;
        for (ssize_t count = 0; (count = ::read(out.get(), block.data(), block.size())) > 0;)
            got.append(block.data(), static_cast<std::size_t>(count));
    });
    const bool written = write_all(in.get(), sent);
    in.close();
    reader.join();
    CHECK(written);
    CHECK(got == sent);
}

TEST_CASE("what can't be written is told") {
    const Descriptor full(::open("/dev/full", O_WRONLY | O_CLOEXEC));
    REQUIRE(full.valid());
    CHECK_FALSE(write_all(full.get(), "text"));
    CHECK(errno == ENOSPC);
}

TEST_CASE("a file without a folder is in this one") {
    CHECK(folder_of("a.ply") == ".");
    CHECK(folder_of("models/a.ply") == "models");
}
