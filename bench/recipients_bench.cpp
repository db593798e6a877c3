// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  The tables of docs/recipients.md: a million copies, wrong accusations, and copies that were mixed.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <wm3d/attack.hpp>
#include <wm3d/io.hpp>
#include <wm3d/key.hpp>
#include <wm3d/payload.hpp>
#include <wm3d/watermark/identify.hpp>
#include <wm3d/watermark/mark.hpp>

namespace {

using namespace wm3d;

constexpr double rmax = 0.1, pf = 1e-6;

std::vector<std::uint64_t> buyers(std::size_t count, unsigned level) {
    std::vector<std::uint64_t> numbers;
    for (std::size_t r = 0; r < count; ++r)
        numbers.push_back(payload::copy_number("work", fmt::format("buyer {}", r), level));
    return numbers;
}

/// Normal numbers of deviation 1, near enough: sums of four uniform ones.
std::vector<double> noise(std::size_t count, std::uint64_t number) {
    std::vector<double> sum(count, 0.0), part(count);
    key::Stream stream(key::null_secret(77, number), key::Purpose::trial, 0);
    for (int k = 0; k < 4; ++k) {
        stream.fill_symmetric(part, std::sqrt(3.0 / 4));
        for (std::size_t j = 0; j < count; ++j)
            sum[j] += part[j];
    }
    return sum;
}

/// What a suspect says that was made from the mean of some copies, each of which alone would score `sigmas`.
detect::LinearStatistic suspect(const key::Secret& secret, std::span<const std::uint64_t> guilty,
                                unsigned level, double sigmas, std::uint64_t number) {
    std::vector<double> c = noise(key::sequence_length(level), number);
    const double scale = sigmas / std::sqrt(static_cast<double>(c.size())) / payload::sign_height(rmax) /
                         static_cast<double>(guilty.size());
    for (const std::uint64_t copy : guilty) {
        const std::vector<double> sequence = payload::copy_sequence(secret, level, rmax, copy);
        for (std::size_t j = 0; j < c.size(); ++j)
            c[j] += scale * sequence[j];
    }
    return {std::move(c), rmax};
}

/// Highest resident memory of this process so far, MB.
std::string peak_memory() {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with("VmHWM:"))
            return fmt::format("{:.0f} MB", std::stod(line.substr(6)) / 1024);
    return "unknown";
}

void million(unsigned level) {
    const key::Secret secret = key::null_secret(1, 1);
    const std::vector<std::uint64_t> numbers = buyers(1'000'000, level);
    const auto statistic = suspect(secret, std::span(numbers).subspan(123'456, 1), level, 12, 1);
    const auto start = std::chrono::steady_clock::now();
    const std::clock_t processor = std::clock();
    const std::vector<double> scores = payload::copy_scores(secret, statistic, numbers);
    const auto accused = payload::accuse(statistic, scores, std::log10(pf), numbers.size());
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
    fmt::print("| {} | {:.1f} s | {:.1f} s | {} | {} |\n", level, passed.count(),
               static_cast<double>(std::clock() - processor) / CLOCKS_PER_SEC, peak_memory(),
               accused.size() == 1 && accused[0].copy == 123'456 ? fmt::format("{:.1f}", accused[0].log10_p)
                                                                 : "wrong");
}

/// Trials of one guilty copy among a thousand: how often it is named, and how often anybody else.
void innocents(double sigmas, std::size_t trials) {
    constexpr unsigned level = 4;
    const key::Secret secret = key::null_secret(1, 2);
    const std::vector<std::uint64_t> numbers = buyers(1000, level);
    std::size_t right = 0, wrong = 0;
    for (std::size_t t = 0; t < trials; ++t) {
        const std::size_t guilty = t % numbers.size();
        const auto statistic = suspect(secret, std::span(numbers).subspan(guilty, 1), level, sigmas, t);
        for (const payload::Accusation& a : payload::accuse(
                 statistic, payload::copy_scores(secret, statistic, numbers), std::log10(pf), numbers.size()))
            ++(a.copy == guilty ? right : wrong);
    }
    fmt::print("{} trials at {} deviations: the right one named in {}, another in {}\n", trials, sigmas,
               right, wrong);
}

/// The mean of the copies, or for every vertex the place that one of them gives it.
std::vector<Vec3> mixed(const std::vector<std::vector<Vec3>>& copies, std::size_t count, bool mean) {
    std::vector<Vec3> result = copies.front();
    std::vector<std::uint64_t> draw(result.size());
    key::Stream(key::null_secret(5, count), key::Purpose::trial, 0).fill(draw);
    for (std::size_t i = 0; i < result.size(); ++i) {
        if (!mean) {
            result[i] = copies[draw[i] % count][i];
            continue;
        }
        Vec3 sum = Vec3::Zero();
        for (std::size_t k = 0; k < count; ++k)
            sum += copies[k][i];
        result[i] = sum / static_cast<double>(count);
    }
    return result;
}

/// Copies of a mesh for the first `count` buyers.
std::vector<std::vector<Vec3>> copies_of(const TriangleMesh& mesh, const key::Key& key, std::size_t count) {
    std::vector<std::vector<Vec3>> copies;
    for (std::size_t r = 0; r < count; ++r) {
        watermark::MarkOptions options;
        options.content.copy = payload::CopyLabel{"work", fmt::format("buyer {}", r)};
        copies.push_back(watermark::mark(mesh, key, options).positions);
    }
    return copies;
}

/// What a suspect gives away, without a search.
watermark::IdentifyReport identified(const TriangleMesh& suspect, const key::Key& key,
                                     std::span<const watermark::IssuedCopy> issued) {
    watermark::IdentifyOptions options;
    options.verify.pf = pf;
    options.verify.search = watermark::SearchUse::never;
    return watermark::identify(suspect, key, issued, options);
}

/// Real copies, attacked, each among many crowds of a thousand: how often the right one is named, and how often anybody
/// else of a crowd that is drawn anew for every trial.
void crowds(const std::filesystem::path& path, std::size_t trials, const std::vector<std::string>& attacks) {
    constexpr std::size_t keys = 5, crowd = 1000;
    const TriangleMesh mesh = io::read(path).mesh();
    std::size_t suspects = 0, right = 0, drawn = 0, wrong = 0;
    double worst = -1e300, nearest = 0;
    for (std::size_t k = 0; k < keys; ++k) {
        const key::Key key = key::Key::generate("bench");
        const unsigned level = watermark::default_level(key.parameters(), mesh.positions.size());
        std::vector<watermark::IssuedCopy> issued;
        for (const std::uint64_t number : buyers(crowd, level))
            issued.push_back({number, level});
        TriangleMesh copy = mesh;
        copy.positions = copies_of(mesh, key, 1).front();
        for (const std::string& attack : attacks) {
            const auto report =
                identified(attack::apply(copy, attack::parse_chain(attack + "+similarity"), k), key, issued);
            ++suspects;
            for (const payload::Accusation& a : report.accused) {
                ++(a.copy == 0 ? right : wrong);
                worst = a.copy == 0 ? std::max(worst, a.log10_p) : worst;
            }
            for (std::size_t t = 0; t < trials; ++t, ++drawn) {
                std::vector<std::uint64_t> innocent;
                for (std::size_t r = 0; r < crowd; ++r)
                    innocent.push_back(
                        payload::copy_number("another work", fmt::format("buyer {} of {}", r, drawn), level));
                const std::vector<double> scores =
                    payload::copy_scores(key.secret(), report.content, innocent);
                nearest = std::max(nearest, *std::ranges::max_element(scores));
                wrong += payload::accuse(report.content, scores, std::log10(pf), crowd).size();
            }
        }
    }
    fmt::print("| {} | {} of {} | {:.1f} | {} | {} | {:.2f} |\n", path.stem().string(), right, suspects,
               worst, drawn, wrong, nearest);
}

void collude(const std::filesystem::path& path, const std::vector<std::string>& attacks) {
    const TriangleMesh mesh = io::read(path).mesh();
    const key::Key key = key::Key::generate("bench");
    const unsigned level = watermark::default_level(key.parameters(), mesh.positions.size());
    std::vector<watermark::IssuedCopy> issued;
    for (const std::uint64_t number : buyers(1000, level))
        issued.push_back({number, level});
    const std::vector<std::vector<Vec3>> copies = copies_of(mesh, key, 8);
    for (const bool mean : {true, false})
        for (const std::size_t count : {1u, 2u, 3u, 5u, 8u}) {
            std::vector<std::string> cells;
            for (const std::string& attack : attacks) {
                TriangleMesh copy = mesh;
                copy.positions = mixed(copies, count, mean);
                const TriangleMesh suspect_mesh =
                    attack::apply(copy, attack::parse_chain(attack + "+similarity"), 1);
                const auto report = identified(suspect_mesh, key, issued);
                std::size_t right = 0;
                for (const payload::Accusation& a : report.accused)
                    right += a.copy < count;
                cells.push_back(
                    fmt::format("{}/{}{} ({:.1f}{})", right, count,
                                report.accused.size() > right ? " and wrong ones" : "", report.best_sigmas,
                                right > 0 ? fmt::format(", {:.1f}", report.accused.front().log10_p) : ""));
            }
            fmt::print("| {} | {}, {} | {} |\n", path.stem().string(), mean ? "mean" : "vertices", count,
                       fmt::join(cells, " | "));
            std::fflush(stdout);
        }
}

} // namespace

int main(int count, char** arguments) {
    const std::vector<std::string> words(arguments + 1, arguments + count);
    if (words == std::vector<std::string>{"million"})
        for (const unsigned level : {4u, 5u, 6u})
            million(level);
    else if (words.size() == 3 && words[0] == "innocents")
        innocents(std::stod(words[1]), std::stoul(words[2]));
    else if (words.size() >= 3 && words[0] == "collude")
        collude(words[1], {words.begin() + 2, words.end()});
    else if (words.size() >= 4 && words[0] == "crowds")
        crowds(words[1], std::stoul(words[2]), {words.begin() + 3, words.end()});
    else {
        fmt::print(
            stderr,
            "usage: recipients_bench million | innocents SIGMAS TRIALS | crowds MESH TRIALS ATTACK... | "
            "collude MESH ATTACK...\n");
        return 2;
    }
}
