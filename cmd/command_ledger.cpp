// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_ledger.hpp"

#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <wm3d/io.hpp>
#include <wm3d/ledger.hpp>

#include "support/mesh_files.hpp"
#include "support/output.hpp"

namespace wm3d::cmd {

namespace {

using nlohmann::ordered_json;

struct LedgerArguments {
    std::string action;
    std::string path;
    std::string output = "-";
    bool overwrite = false;
};

ordered_json owner_json(const ledger::Ledger& book) {
    return {{"fingerprint", book.owner().fingerprint}, {"commitment", book.owner().commitment}};
}

int list(const LedgerArguments& arguments, Output& output) {
    const ledger::Ledger book(arguments.path);
    ordered_json copies = ordered_json::array();
    book.visit([&](const ledger::Entry& entry) {
        if (output.json())
            copies.push_back(ordered_json::parse(ledger::to_json_line(entry)));
        else
            output.print(fmt::format("{:>6}  {}  {}  {}  ({})\n", entry.number, entry.time,
                                     entry.work.substr(0, 12), entry.recipient, entry.file));
    });
    output.say(
        fmt::format("{} holds {} copies of key {}.", arguments.path, book.size(), book.owner().fingerprint));
    output.print_json({{"ledger", arguments.path}, {"key", owner_json(book)}, {"copies", copies}});
    return exit_done;
}

/// JSON Lines: the ledger's own line first, then one for each entry.
int write_lines(const LedgerArguments& arguments, Output& output) {
    if (arguments.output != "-")
        check_target(arguments.output, arguments.overwrite);
    const ledger::Ledger book(arguments.path);
    std::string lines = ordered_json{{"schema", "wm3d.ledger/1"}, {"key", owner_json(book)}}.dump() + "\n";
    book.visit([&](const ledger::Entry& entry) { lines += ledger::to_json_line(entry) + "\n"; });
    if (arguments.output == "-")
        output.write_bytes(lines);
    else
        io::write_file(arguments.output, lines, {.overwrite = arguments.overwrite});
    output.say(fmt::format("Exported {} copies.", book.size()));
    return exit_done;
}

int check(const LedgerArguments& arguments, Output& output) {
    const ledger::CheckReport report = ledger::Ledger(arguments.path).check();
    if (report.defects.empty())
        output.print(fmt::format("whole: {} holds {} copies, each following the one before it.\nhead  {}\n",
                                 arguments.path, report.entries, report.head));
    for (const std::string& defect : report.defects)
        output.fail(fmt::format("{}: {}", arguments.path, defect));
    output.print_json({{"ledger", arguments.path},
                       {"entries", report.entries},
                       {"head", report.head},
                       {"defects", report.defects}});
    return report.defects.empty() ? exit_done : exit_check_failed;
}

} // namespace

Action declare_ledger(CLI::App& app) {
    const auto arguments = std::make_shared<LedgerArguments>();
    app.description(
        "Tells what a ledger of copies holds: `list` prints it, `export` writes it as JSON Lines, `check`\n"
        "makes sure that nothing was changed, removed or put in since. Compare the head that `check` prints\n"
        "with one that was noted before: it also tells a ledger that lost its last entries.\n"
        "`mark --for` enters copies. Exit status of `check`: 0 whole, 1 not, 2 error.");
    app.add_option("ACTION", arguments->action, "list, export or check")
        ->option_text("ACTION")
        ->required()
        ->check(CLI::IsMember({"list", "export", "check"}));
    app.add_option("LEDGER", arguments->path, "The ledger")->option_text("FILE")->required();
    app.add_option("-o,--output", arguments->output, "With export: file to write [standard output]")
        ->option_text("FILE");
    app.add_flag("--overwrite", arguments->overwrite, "Replace an output that exists");
    app.footer("Examples:\n  wm3d ledger list shop.ledger\n  wm3d ledger export shop.ledger -o copies.jsonl\n"
               "  wm3d ledger check shop.ledger");
    return [arguments](Output& output) {
        return arguments->action == "list"     ? list(*arguments, output)
               : arguments->action == "export" ? write_lines(*arguments, output)
                                               : check(*arguments, output);
    };
}

} // namespace wm3d::cmd
