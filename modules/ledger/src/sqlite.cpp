// SPDX-License-Identifier: GPL-3.0-or-later
#include "sqlite.hpp"

#include <sqlite3.h>

namespace wm3d::ledger {

namespace {

[[noreturn]] void fail(sqlite3* connection, int code) {
    throw SqliteError(code & 0xff, connection ? sqlite3_errmsg(connection) : sqlite3_errstr(code));
}

} // namespace

void Statement::Finalize::operator()(sqlite3_stmt* statement) const {
    sqlite3_finalize(statement);
}

Statement::Statement(sqlite3* connection, std::string_view sql) : connection_(connection) {
    sqlite3_stmt* statement = nullptr;
    require(sqlite3_prepare_v2(connection, sql.data(), static_cast<int>(sql.size()), &statement, nullptr));
    statement_.reset(statement);
}

void Statement::require(int code) const {
    if (code != SQLITE_OK)
        fail(connection_, code);
}

Statement& Statement::bind(int parameter, std::string_view text) {
    // The text has to live until the last step, so SQLite keeps a copy.
    require(sqlite3_bind_text(statement_.get(), parameter, text.data(), static_cast<int>(text.size()),
                              SQLITE_TRANSIENT));
    return *this;
}

Statement& Statement::bind(int parameter, std::int64_t number) {
    require(sqlite3_bind_int64(statement_.get(), parameter, number));
    return *this;
}

bool Statement::step() {
    const int code = sqlite3_step(statement_.get());
    if (code != SQLITE_ROW && code != SQLITE_DONE)
        fail(connection_, code);
    return code == SQLITE_ROW;
}

std::string Statement::text(int column) const {
    const auto* bytes = reinterpret_cast<const char*>(sqlite3_column_text(statement_.get(), column));
    return bytes
               ? std::string(bytes, static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), column)))
               : std::string();
}

std::int64_t Statement::number(int column) const {
    return sqlite3_column_int64(statement_.get(), column);
}

void Connection::Close::operator()(sqlite3* connection) const {
    sqlite3_close_v2(connection);
}

Connection::Connection(const std::string& path, bool writable, int patience_ms) {
    sqlite3* connection = nullptr;
    const int flags = writable ? SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE : SQLITE_OPEN_READONLY;
    const int code = sqlite3_open_v2(path.c_str(), &connection, flags, nullptr);
    connection_.reset(connection); // also where it failed
    if (code != SQLITE_OK)
        fail(connection, code);
    sqlite3_busy_timeout(connection, patience_ms);
}

void Connection::run(std::string_view sql) const {
    char* message = nullptr;
    const int code = sqlite3_exec(connection_.get(), std::string(sql).c_str(), nullptr, nullptr, &message);
    sqlite3_free(message);
    if (code != SQLITE_OK)
        fail(connection_.get(), code);
}

} // namespace wm3d::ledger
