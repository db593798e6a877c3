// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/ledger/ledger.hpp>

#include <filesystem>
#include <fstream>
#include <thread>

#include <fmt/format.h>
#include <sqlite3.h>

#include <doctest/doctest.h>
#include <wm3d/core/error.hpp>

using namespace wm3d;
using namespace wm3d::ledger;

namespace {

const Owner owner{"0123456789abcdef", std::string(64, 'c')};

/// A folder that goes away with the test.
struct Folder {
    std::filesystem::path path = std::filesystem::temp_directory_path() /
                                 fmt::format("wm3d-ledger-{}", static_cast<const void*>(this));
    Folder() { std::filesystem::create_directories(path); }
    ~Folder() { std::filesystem::remove_all(path); }
    std::filesystem::path operator/(const char* name) const { return path / name; }
};

Entry draft(const std::string& recipient, const std::string& work = std::string(64, 'a')) {
    Entry entry;
    entry.work = work;
    entry.file = "statue.obj";
    entry.recipient = recipient;
    entry.copy = std::string(64, 'b');
    entry.level = 5;
    entry.settings = R"({"visibility":0.1})";
    entry.tool = "wm3d test";
    return entry;
}

Ledger made(const std::filesystem::path& path, int entries) {
    Ledger ledger(path, {.owner = owner, .create = true});
    for (int k = 0; k < entries; ++k)
        ledger.add(draft(fmt::format("buyer {}", k))).commit();
    return ledger;
}

void meddle(const std::filesystem::path& path, const char* sql) {
    sqlite3* db = nullptr;
    REQUIRE(sqlite3_open(path.c_str(), &db) == SQLITE_OK);
    CHECK(sqlite3_exec(db, sql, nullptr, nullptr, nullptr) == SQLITE_OK);
    sqlite3_close(db);
}

template<typename E>
std::string complaint(const std::filesystem::path& path, const OpenOptions& options = {}) {
    try {
        Ledger(path, options).check();
    } catch (const E& error) {
        return error.what();
    }
    return "";
}

bool says(const std::string& text, const char* part) {
    return text.find(part) != std::string::npos;
}

} // namespace

TEST_CASE("what is entered is found again, by name, by number and in order") {
    const Folder folder;
    made(folder / "l", 3);
    const Ledger ledger(folder / "l", {.owner = owner});
    CHECK(ledger.size() == 3);
    CHECK(ledger.owner() == owner);
    const auto found = ledger.find(std::string(64, 'a'), "buyer 1");
    REQUIRE(found);
    CHECK(found->number == 2);
    CHECK(found->level == 5);
    CHECK(found->settings == R"({"visibility":0.1})");
    CHECK(found->time.size() == 20);
    CHECK(ledger.find(3)->recipient == "buyer 2");
    CHECK_FALSE(ledger.find(4));
    CHECK_FALSE(ledger.find(std::string(64, 'b'), "buyer 1"));
    std::vector<std::string> names;
    ledger.visit([&](const Entry& entry) { names.push_back(entry.recipient); });
    CHECK(names == std::vector<std::string>{"buyer 0", "buyer 1", "buyer 2"});
    const CheckReport report = ledger.check();
    CHECK(report.defects.empty());
    CHECK(report.entries == 3);
    CHECK(report.head == ledger.find(3)->digest);
}

TEST_CASE("an empty file, as a full disk leaves it, is a ledger yet to be made") {
    const Folder folder;
    std::ofstream(folder / "l").close();
    CHECK_THROWS_WITH_AS(Ledger(folder / "l"), doctest::Contains("no such ledger"), InputError);
    CHECK(made(folder / "l", 1).size() == 1);
}

TEST_CASE("an addition that is not committed leaves nothing") {
    const Folder folder;
    Ledger ledger = made(folder / "l", 1);
    {
        const Addition addition = ledger.add(draft("Ann"));
        CHECK(addition.entry().number == 2);
    }
    CHECK(ledger.size() == 1);
    ledger.add(draft("Ben")).commit();
    CHECK(ledger.find(2)->recipient == "Ben");
    CHECK(ledger.check().defects.empty());
}

TEST_CASE("a name twice for the same work is refused, for another work it isn't") {
    const Folder folder;
    Ledger ledger = made(folder / "l", 1);
    CHECK_THROWS_WITH_AS(ledger.add(draft("buyer 0")), doctest::Contains("for 'buyer 0' already"),
                         ParameterError);
    CHECK_NOTHROW(ledger.add(draft("buyer 0", std::string(64, 'd'))).commit());
    CHECK(ledger.size() == 2);
}

TEST_CASE("what is changed, removed or put in shows") {
    const Folder folder;
    for (const char* sql :
         {"UPDATE copies SET recipient = 'Eve' WHERE number = 2", "DELETE FROM copies WHERE number = 2",
          "UPDATE copies SET settings = 'x' WHERE number = 1",
          "INSERT INTO copies SELECT 4, time, 'w', file, 'Eve', copy, level, settings, tool, previous, "
          "digest, receipt FROM "
          "copies WHERE number = 3"}) {
        std::filesystem::remove(folder / "l");
        made(folder / "l", 3);
        meddle(folder / "l", sql);
        CHECK_FALSE(Ledger(folder / "l").check().defects.empty());
    }
}

TEST_CASE("files that are no ledger, cut, of a newer version or another key's are refused in a sentence") {
    const Folder folder;
    CHECK(says(complaint<InputError>(folder / "none"), "no such ledger"));
    std::ofstream(folder / "text") << std::string(5000, 'x');
    CHECK(says(complaint<InputError>(folder / "text"), "is no ledger"));
    meddle(folder / "database", "CREATE TABLE t (x)");
    CHECK(says(complaint<InputError>(folder / "database"), "no ledger"));
    made(folder / "l", 40);
    CHECK(says(complaint<ParameterError>(folder / "l", {.owner = Owner{"f", "c"}}),
               "belongs to key 0123456789abcdef"));
    std::filesystem::copy_file(folder / "l", folder / "cut");
    std::filesystem::resize_file(folder / "cut", std::filesystem::file_size(folder / "cut") / 2);
    std::string cut;
    try {
        const CheckReport report = Ledger(folder / "cut").check();
        REQUIRE_FALSE(report.defects.empty());
        cut = report.defects.front();
    } catch (const InputError& error) {
        cut = error.what();
    }
    CHECK((says(cut, "cut short") || says(cut, "damaged")));
    meddle(folder / "l", "PRAGMA user_version = 3");
    CHECK(says(complaint<InputError>(folder / "l"), "use a newer wm3d"));
    CHECK(says(complaint<OutputError>(folder / "no/such/folder", {.owner = owner, .create = true}),
               "can't be opened"));
}

TEST_CASE("a work keeps the receipt of its first copy, and a change of it shows") {
    const Folder folder;
    const std::string other(64, 'd');
    {
        Ledger ledger(folder / "l", {.owner = owner, .create = true});
        ledger.add(draft("Ann")).commit(); // without one
        CHECK_FALSE(ledger.has_receipt(std::string(64, 'a')));
        { const Addition given_up = ledger.add(draft("Eve"), "not this one"); }
        ledger.add(draft("Ben"), "first").commit();
        ledger.add(draft("Cid"), "second").commit();
        ledger.add(draft("Ann", other), "of another work").commit();
    }
    const Ledger ledger(folder / "l");
    CHECK(ledger.has_receipt(other));
    const std::vector<WorkReceipt> receipts = ledger.receipts();
    REQUIRE(receipts.size() == 2);
    CHECK(receipts[0].work == other);
    CHECK(receipts[0].text == "of another work");
    CHECK(receipts[1].text == "first");
    CHECK(ledger.find(1)->receipt.empty());
    CHECK(ledger.find(2)->receipt.size() == 64);
    CHECK(ledger.find(3)->receipt == ledger.find(2)->receipt);
    CHECK(ledger.check().defects.empty());
    meddle(folder / "l", "UPDATE receipts SET text = 'third' WHERE text = 'first'");
    const CheckReport changed = Ledger(folder / "l").check();
    REQUIRE(changed.defects.size() == 2);
    CHECK(changed.defects[0] == "the receipt of entry 2 was changed or removed");
}

TEST_CASE("a ledger of version 1 is read as it is, and takes receipts from the next entry on") {
    const Folder folder;
    made(folder / "l", 2);
    // What version 2 added is taken away again: the entries' digests are those of version 1.
    meddle(folder / "l",
           "ALTER TABLE copies DROP COLUMN receipt; DROP TABLE receipts; PRAGMA user_version = 1");
    {
        const Ledger old(folder / "l");
        CHECK(old.size() == 2);
        CHECK(old.receipts().empty());
        CHECK_FALSE(old.has_receipt(std::string(64, 'a')));
        CHECK(old.find(2)->receipt.empty());
        CHECK(old.check().defects.empty());
    }
    Ledger ledger(folder / "l", {.owner = owner, .create = true});
    { const Addition given_up = ledger.add(draft("Ann"), "receipt"); }
    CHECK(ledger.receipts().empty());
    ledger.add(draft("Ann"), "receipt").commit();
    CHECK(ledger.receipts().size() == 1);
    CHECK(ledger.find(3)->receipt.size() == 64);
    CHECK(ledger.check().defects.empty());
}

TEST_CASE("a ledger that another program holds is waited for, then refused") {
    const Folder folder;
    Ledger first = made(folder / "l", 1);
    Ledger second(folder / "l", {.owner = owner, .create = true, .patience_ms = 50});
    {
        const Addition held = first.add(draft("Ann"));
        CHECK_THROWS_WITH_AS(second.add(draft("Ben")), doctest::Contains("another program is writing"),
                             OutputError);
    }
    CHECK_NOTHROW(second.add(draft("Ben")).commit());
}

TEST_CASE("writers at the same time wait for each other, and the chain is whole") {
    const Folder folder;
    std::vector<std::thread> writers;
    for (int w = 0; w < 4; ++w)
        writers.emplace_back([&, w] {
            Ledger ledger(folder / "l", {.owner = owner, .create = true});
            for (int k = 0; k < 10; ++k)
                ledger.add(draft(fmt::format("{} of {}", k, w))).commit();
        });
    for (std::thread& writer : writers)
        writer.join();
    const CheckReport report = Ledger(folder / "l").check();
    CHECK(report.entries == 40);
    CHECK(report.defects.empty());
}

TEST_CASE("a line of JSON holds every field") {
    const Folder folder;
    const Entry entry = *made(folder / "l", 1).find(1);
    const std::string line = to_json_line(entry);
    for (const char* part :
         {"\"number\":1", "\"recipient\":\"buyer 0\"", "\"settings\":{\"visibility\":0.1}", "\"digest\":\""})
        CHECK(says(line, part));
    CHECK(line.find('\n') == std::string::npos);
}
