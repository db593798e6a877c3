// SPDX-License-Identifier: GPL-3.0-or-later
// A fuzzing target without libFuzzer: replay TARGET COUNT tries the seeds of the target and COUNT mutations of
// them, the same in every run. It finds again what once was found; scripts/fuzz looks for what nobody knows.
// If one fails, its number is told; replay TARGET COUNT NUMBER writes that input to standard output.
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <iostream>

#include <unistd.h>

#include <wm3d/core/split_mix.hpp>

#include "target.hpp"

namespace {

using namespace wm3d;

class Mutator {
public:
    explicit Mutator(std::string_view target) : seeds_(fuzz::seeds(target)), words_(fuzz::words(target)) {}

    /// Seeds first, then mutations; each depends on its number alone.
    std::string input(std::size_t number) {
        if (number < seeds_.size())
            return seeds_[number];
        state_ = number;
        std::string bytes = seeds_[below(seeds_.size())];
        for (std::size_t changes = 1 + below(4); changes > 0; --changes)
            change(bytes);
        return bytes;
    }

    std::size_t seeds() const { return seeds_.size(); }

private:
    std::size_t below(std::size_t n) { return split_mix(state_) % std::max<std::size_t>(n, 1); }

    void change(std::string& bytes) {
        const std::size_t at = below(bytes.size()), length = 1 + below(std::size_t{1} << below(8));
        switch (below(7)) {
        case 0:
            if (!bytes.empty())
                bytes[at] = static_cast<char>(below(256));
            break;
        case 1:
            bytes.insert(at, words_[below(words_.size())]);
            break;
        case 2:
            bytes.replace(at, length, words_[below(words_.size())]);
            break;
        case 3:
            bytes.erase(at, length);
            break;
        case 4:
            bytes.insert(below(bytes.size()), bytes.substr(at, length));
            break;
        case 5:
            bytes.resize(at);
            break;
        default: { // one seed's end behind another's beginning
            const std::string& other = seeds_[below(seeds_.size())];
            bytes = bytes.substr(0, at) + other.substr(below(other.size()));
        }
        }
    }

    std::vector<std::string> seeds_, words_;
    std::uint64_t state_ = 0;
};

std::size_t number_of_input = 0;

/// Tells the input that was being tried, then dies as it would have.
extern "C" void tell_input(int signal) {
    char text[64];
    const int size = std::snprintf(text, sizeof text, "replay: input %zu failed\n", number_of_input);
    [[maybe_unused]] const ssize_t ignored = ::write(STDERR_FILENO, text, static_cast<std::size_t>(size));
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}

int replay(Mutator& mutator, std::size_t mutations) {
    for (const int signal : {SIGABRT, SIGSEGV, SIGFPE, SIGILL, SIGBUS})
        std::signal(signal, tell_input);
    for (number_of_input = 0; number_of_input < mutator.seeds() + mutations; ++number_of_input) {
        const std::string bytes = mutator.input(number_of_input);
        LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
    }
    std::cout << mutator.seeds() << " seeds and " << mutations << " mutations\n";
    return 0;
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 3 || std::ranges::find(fuzz::targets, std::string_view(argv[1])) == std::end(fuzz::targets)) {
        std::cerr << "usage: replay TARGET COUNT [NUMBER]\n";
        return 2;
    }
    Mutator mutator(argv[1]);
    if (argc == 3)
        return replay(mutator, std::strtoul(argv[2], nullptr, 10));
    std::cout << mutator.input(std::strtoul(argv[3], nullptr, 10));
    return 0;
}
