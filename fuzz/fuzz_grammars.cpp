// SPDX-License-Identifier: GPL-3.0-or-later
// Any text is a chain of attacks, a list of damages, a command line, the log of a bench or of trials, or is
// refused in a sentence; what was understood is understood again as it is written. The first byte chooses.
#include <sstream>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sys/mman.h>
#include <unistd.h>

#include <wm3d/attack/spec.hpp>
#include <wm3d/study/bench_log.hpp>
#include <wm3d/study/damage.hpp>
#include <wm3d/study/trial_log.hpp>

#include "commands.hpp"
#include "support/usage.hpp"
#include "target.hpp"

using namespace wm3d;

namespace {

void read_chain(std::string_view text) {
    const std::vector<attack::AttackSpec> chain = attack::parse_chain(text);
    const std::string written = attack::to_string(chain);
    fuzz::require(attack::to_string(attack::parse_chain(written)) == written);
}

void read_damages(std::string_view text) {
    for (const study::NamedDamage& damage : study::parse_damages(text))
        fuzz::require(study::parse_damages(damage.name).size() == 1);
}

/// The first line is a command, every other an argument. Nothing is run.
void read_command_line(std::string_view text) {
    std::vector<std::string> words;
    std::istringstream lines{std::string(text)};
    for (std::string line; std::getline(lines, line);)
        words.push_back(line);
    if (words.empty())
        return;
    const cmd::Command* command = cmd::find_command(words.front());
    if (command == nullptr)
        return;
    CLI::App app{std::string(command->summary), words.front()};
    cmd::OutputOptions options;
    const cmd::Action action = cmd::declare(*command, app, options); // it owns what is parsed
    fuzz::require(action != nullptr);
    try {
        app.parse(std::vector<std::string>(words.rbegin(), std::prev(words.rend())));
    } catch (const CLI::CallForHelp&) {
        fuzz::require(!cmd::help_text(app, 80).empty());
    } catch (const CLI::ParseError& error) {
        const std::string sentence = cmd::usage_complaint(app, error);
        fuzz::require(!sentence.empty());
    }
}

/// A file of memory.
class MemoryFile {
public:
    explicit MemoryFile(std::string_view bytes) : file_(::memfd_create("fuzz", MFD_CLOEXEC)) {
        fuzz::require(file_ >= 0 &&
                      ::write(file_, bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size()));
    }
    ~MemoryFile() { ::close(file_); }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;
    std::string path() const { return fmt::format("/proc/self/fd/{}", file_); }

private:
    int file_;
};

void read_bench_log(std::string_view text) {
    const MemoryFile file(text);
    const nlohmann::ordered_json settings{{"seed", 1}};
    std::size_t items = 0;
    {
        study::BenchLog log(file.path(), settings);
        items = log.results().items.size();
        for (const auto& [name, item] : study::BenchResults(log.results()).items)
            log.add(name, item);
    }
    fuzz::require(study::BenchLog(file.path(), settings).results().items.size() == items);
}

void read_trial_log(std::string_view text) {
    const MemoryFile file(text);
    study::TrialLog log(file.path(), "0123456789abcdef");
    for (const auto& [number, trial] : std::map(log.trials("s")))
        log.append("s", trial);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0)
        return 0;
    constexpr void (*readers[])(std::string_view) = {read_chain, read_damages, read_command_line,
                                                     read_bench_log, read_trial_log};
    try {
        readers[data[0] % std::size(readers)]({reinterpret_cast<const char*>(data) + 1, size - 1});
    } catch (const Error&) {
    }
    return 0;
}
