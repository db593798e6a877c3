// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  The robustness bench: models x sizes of marks x keys x attacks, each examined blind after a random
/// similarity, as verify does with its defaults.
#pragma once

#include <vector>

#include <wm3d/attack/spec.hpp>
#include <wm3d/core/progress.hpp>
#include <wm3d/key/key_file.hpp>
#include <wm3d/mesh/triangle_mesh.hpp>
#include <wm3d/study/bench_results.hpp>
#include <wm3d/watermark/defaults.hpp>
#include <wm3d/watermark/mark.hpp>

namespace wm3d::study {

using AttackChain = std::vector<attack::AttackSpec>;

struct BenchSetting {
    std::vector<MarkSize> sizes;
    std::vector<AttackChain> attacks;
    std::size_t keys = 5;
    std::size_t wrong_keys = 20; ///< scored on every attacked copy
    std::uint64_t seed = 1;      ///< of keys and attacks
    bool assisted = false;       ///< also examine with the original at hand
    /// Of the search in all poses that follows where the quick look's p is above 1e-9, as of `verify
    /// --effort`: half a minute of one core at most. 0: the quick look alone.
    double search_effort = 0.2;
    std::size_t payload = 0; ///< bits of a random payload in every mark: 32, 64, 128, or 0 for none
    std::size_t vertices = watermark::default_vertices;
    watermark::Profile profile = watermark::Profile::robust;
    key::PublicParameters parameters{}; ///< of every key
};

/// The published benchmark, then what happens to models today, as far as this build has it.
std::vector<AttackChain> default_attacks();

/// Marks that a mesh still lacks, and items of those marks.
struct BenchWork {
    std::string model;
    std::vector<MarkName> marks; ///< to be made anew: without a BenchMark, or with items that are missing
    std::vector<ItemName> items;
};

class BenchLog;

/// The marks and items of a model that the log lacks.
BenchWork missing_work(const std::string& model, const BenchSetting& setting, const BenchResults& done);

/// Called after every item, from one thread at a time.
using BenchSink = std::function<void()>;

/// Does the work on one mesh and writes the results to the log, on all cores. A mark or an attack that fails
/// is a result too. The results are the same at any number of threads; their order is not.
void run_bench(const TriangleMesh& mesh, const BenchSetting& setting, const BenchWork& work, BenchLog& log,
               const BenchSink& sink, const Progress& progress = {});

} // namespace wm3d::study
