// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/watermark/mark_file.hpp>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <wm3d/core/error.hpp>
#include <wm3d/core/memory.hpp>
#include <wm3d/core/parallel.hpp>
#include <wm3d/embed/turned_faces.hpp>
#include <wm3d/mesh/measure.hpp>
#include <wm3d/mesh/weld.hpp>
#include <wm3d/payload/recipients.hpp>
#include <wm3d/watermark/marker.hpp>
#include <wm3d/watermark/receipt.hpp>

namespace wm3d::watermark {

namespace {

/// The file lies where it was marked, so that the quick look sees the mark, unless its axes are unclear; then
/// it lies about the file's own centre, which is the first that a search tries.
VerifyOptions self_check_options(const MarkOptions& mark, resync::Ambiguity ambiguity) {
    VerifyOptions options;
    options.pf = mark.pf;
    options.read_payload = mark.content.message.has_value();
    options.effort = ambiguity == resync::Ambiguity::none ? 0 : 0.02;
    return options;
}

/// Whether the mark, in the pose in which it was laid down, shows so little that no search that ends there could pay for
/// itself.
bool no_search_would_do(const Suspect& suspect, const Marked& marked, const key::Key& key,
                        const VerifyOptions& check) {
    constexpr double better_nearby = 3; // decades that a search may gain beside that pose
    ExaminationOptions options = examination_options(key.parameters(), check.vertices);
    options.resync = Resync::icp; // no pose but this
    options.poses = {{marked.frame, "as marked"}};
    const Examination there(suspect, std::move(options));
    Sequences sequences(key.secret(), key.parameters().rmax);
    const double log10_p = detect::score_family(there.family(), sequences.function()).log10_p;
    return log10_p + log10_search_price(search::Deformation::none) - better_nearby > std::log10(check.pf);
}

/// What verify says of a marked mesh. The search that may be part of it is made where a quick look finds nothing, and a
/// look at the right place doesn't say that the search would be in vain.
VerifyReport self_check(const Suspect& suspect, const Marked& marked, const key::Key& key,
                        const VerifyOptions& check, const Progress& progress) {
    VerifyOptions quick = check;
    quick.effort = 0;
    VerifyReport report = verify(suspect, key, quick, progress);
    if (check.effort == 0 || report.verdict == detect::Verdict::present ||
        no_search_would_do(suspect, marked, key, check))
        return report;
    return verify(suspect, key, check, progress);
}

/// Whether the copy would be told from a million others.
bool tells_copy(const VerifyReport& check, const key::Key& key, const payload::CopyLabel& copy, double pf) {
    constexpr std::size_t crowd = 1'000'000;
    const std::uint64_t number = payload::copy_number(copy.work, copy.recipient, check.level);
    const std::vector<double> score =
        payload::copy_scores(key.secret(), check.statistic, std::span(&number, 1));
    return !payload::accuse(check.statistic, score, std::log10(pf), crowd).empty();
}

/// Whether what the mark says besides whose it is can be read.
bool is_readable(const VerifyReport& check, const key::Key& key, const MarkOptions& options) {
    const payload::Content& content = options.content;
    return (!content.message || (check.payload && check.payload->message == *content.message)) &&
           (!content.copy || tells_copy(check, key, *content.copy, options.pf));
}

/// Whether the mark would be found on the mesh as it is in memory, before a file rounds it. Not asked where the
/// file's steps are nothing beside the moves.
bool lost_in_storage(const MarkedModel& result, const TriangleMesh& mesh, const key::Key& key,
                     const VerifyOptions& check, const Progress& progress) {
    constexpr double nothing = 0.01;
    if (result.coordinate_step < nothing * result.marked.distortion.normal_rms)
        return false;
    const TriangleMesh in_memory{result.marked.positions, mesh.triangles};
    return self_check(prepare_suspect(in_memory, check.vertices), result.marked, key, check, progress)
               .verdict == detect::Verdict::present;
}

/// Whether verify would find the mark, and read what it says, in the file as it would be written.
bool would_do(const io::Model& model, const Marker& marker, const key::Key& key,
              const MarkModelOptions& options, const VerifyOptions& check, const Progress& progress) {
    try {
        const Marked marked = marker.mark(key.secret(), mark_setting(model.mesh(), key, options.mark));
        io::PatchedFiles files = model.patched_files(marked.positions, options.output_name, options.normals);
        const TriangleMesh written = model.reread(files);
        const VerifyReport report =
            self_check(prepare_suspect(written, check.vertices), marked, key, check, progress);
        return report.verdict == detect::Verdict::present && is_readable(report, key, options.mark);
    } catch (const TooVisible&) {
        return false;
    }
}

/// The number that sizes the mark.
double& size_of(MarkOptions& options) {
    if (options.gamma)
        return *options.gamma;
    return options.strength ? *options.strength : options.visibility;
}

std::string size_option(MarkOptions options) {
    return fmt::format("--{} {:.2g}",
                       options.gamma      ? "gamma"
                       : options.strength ? "strength"
                                          : "visibility",
                       size_of(options));
}

/// With two digits, as it is told: what is told has been tried.
double in_two_digits(double size) {
    return std::stod(fmt::format("{:.2g}", size));
}

/// A larger size that was tried and does, if there is one: doubled until it does, then a little less. Where the largest
/// budget doesn't do, none does.
std::optional<MarkOptions> size_that_would_do(const io::Model& model, const key::Key& key,
                                              MarkModelOptions options, const VerifyOptions& check,
                                              const Progress& progress) {
    constexpr int most_doublings = 5;
    constexpr double most_seen = 0.5; // nobody would want to see more, and each try is a mark
    MarkOptions& mark = options.mark;
    const double most = mark.strength || mark.gamma ? HUGE_VAL : most_seen;
    const Marker marker(model.mesh(), mark.vertices);
    const auto does = [&] { return would_do(model, marker, key, options, check, progress); };
    double too_small = size_of(mark);
    if (most == most_seen) {
        size_of(mark) = most;
        if (too_small >= most || !does())
            return std::nullopt;
    }
    for (int k = 0; k < most_doublings && too_small < most; ++k) {
        size_of(mark) = in_two_digits(std::min(2 * too_small, most));
        if (!does()) {
            too_small = size_of(mark);
            continue;
        }
        const MarkOptions enough = mark;
        size_of(mark) = in_two_digits(std::sqrt(too_small * size_of(mark)));
        return size_of(mark) > too_small && does() ? mark : enough;
    }
    return std::nullopt;
}

/// What would mend a loss: tried, and not only supposed.
std::string remedy(const io::Model& model, const key::Key& key, const MarkModelOptions& options,
                   const MarkedModel& result, const Progress& progress) {
    constexpr double hopeful = -2; // a P_f above 1 % is no verdict
    std::vector<std::string> would_do;
    const VerifyOptions check = self_check_options(options.mark, result.marked.ambiguity);
    if (const auto larger = size_that_would_do(model, key, options, check, progress))
        would_do.push_back(size_option(*larger));
    const double log10_p = result.check.score.log10_p;
    const bool lost = result.loss == Loss::power || result.loss == Loss::storage;
    if (lost && log10_p < hopeful)
        would_do.push_back(fmt::format("--pf {:.1g}", 1.5 * std::pow(10.0, log10_p)));
    if (!would_do.empty())
        return fmt::format("{} would do", fmt::join(would_do, " or "));
    return fmt::format("no larger mark that was tried would do{}; {}", lost ? ", nor a P_f up to 0.01" : "",
                       result.loss == Loss::storage   ? "store more digits"
                       : result.loss == Loss::content ? "give a shorter payload, which needs less"
                                                      : "subdivide the model first");
}

/// Median of the surface's edges; 0 without one.
double typical_edge(const TriangleMesh& mesh) {
    std::vector<double> edges;
    for (const Triangle& t : mesh.triangles)
        for (std::size_t k = 0; k < 3; ++k)
            edges.push_back((mesh.positions[t[k]] - mesh.positions[t[(k + 1) % 3]]).norm());
    if (edges.empty())
        return 0;
    const auto middle = edges.begin() + static_cast<std::ptrdiff_t>(edges.size() / 2);
    std::nth_element(edges.begin(), middle, edges.end());
    return *middle;
}

/// Whether the model lies so far away, as maps have them, that its file's numbers hold steps and no shape; then
/// that is the loss.
bool lies_too_far(const io::Model& model, MarkedModel& result) {
    constexpr double near = 100;         // times its own size
    constexpr double fine_enough = 0.25; // of an edge
    const Box box = surface_box(model.mesh());
    const double distance = std::max(box.min.cwiseAbs().maxCoeff(), box.max.cwiseAbs().maxCoeff());
    const double edge = typical_edge(model.mesh());
    if (distance <= near * box.diagonal() || result.coordinate_step <= fine_enough * edge)
        return false;
    result.loss = Loss::distance;
    result.remedy = fmt::format("at {:.2g} from the origin the file's numbers are {:.2g} apart, too coarse "
                                "for edges of {:.2g}; export "
                                "the model in double precision, or move it to the origin before it is stored",
                                distance, result.coordinate_step, edge);
    return true;
}

io::Format format_of(const std::filesystem::path& path, const std::optional<io::Format>& fallback) {
    if (const auto format = io::format_of_name(path.filename().string()))
        return *format;
    if (fallback)
        return *fallback;
    throw ParameterError(
        fmt::format("{}: the extension names no known format; use one of obj, ply, stl, off, "
                    "gltf, glb, or give the format",
                    path.string()));
}

/// The vertices that lie in one place with another.
std::vector<Index> fallen_together(std::span<const Vec3> positions) {
    const std::vector<Index> place = weld(positions, {}).vertex_of;
    std::vector<Index> at_place(positions.size(), 0), together;
    for (const Index p : place)
        ++at_place[p];
    for (Index v = 0; v < place.size(); ++v)
        if (at_place[place[v]] > 1)
            together.push_back(v);
    return together;
}

/// Positions whose vertices stay where they were if the file's steps would let them fall together, which readers
/// take for one vertex, or turn a face over.
std::vector<Vec3> kept_apart(const io::Model& model, std::vector<Vec3> positions) {
    const TriangleMesh& mesh = model.mesh();
    for (bool any = true; any;) {
        const std::vector<Vec3> stored = model.stored_positions(positions);
        std::vector<Index> back = fallen_together(stored);
        for (const Index f : embed::turned_faces(mesh, stored))
            back.insert(back.end(), mesh.triangles[f].begin(), mesh.triangles[f].end());
        any = false;
        for (const Index v : back) {
            any |= positions[v] != mesh.positions[v];
            positions[v] = mesh.positions[v];
        }
    }
    return positions;
}

/// Whether the file as it would be written holds the surface of the one that was read, its vertices moved.
bool is_same_surface(const TriangleMesh& written, const TriangleMesh& mesh) {
    return written.triangles == mesh.triangles && embed::turned_faces(mesh, written.positions).empty();
}

/// One mark and its verdict. For a loss, the remedy is still to be found, but where no mark is little enough to be seen.
MarkedModel mark_once(const io::Model& model, const key::Key& key, const MarkModelOptions& options,
                      const Progress& progress) {
    MarkedModel result;
    result.coordinate_step = model.coordinate_step();
    model.let_bytes_go();
    try {
        const auto stored = [&](std::span<const Vec3> wanted) { return model.stored_positions(wanted); };
        result.marked = mark(model.mesh(), key, options.mark, progress, stored);
    } catch (const TooVisible& too_visible) {
        result.marked.ambiguity = resync::ambiguity_of(shape_moments(model.mesh()).own());
        result.loss = Loss::visibility;
        if (!lies_too_far(model, result))
            result.remedy =
                fmt::format("{}; {}", too_visible.what(), remedy(model, key, options, result, progress));
        return result;
    }
    const auto make_room = [&] {
        constexpr std::size_t dense = 200'000;
        if (result.marked.positions.size() > dense)
            return_freed_memory();
    };
    make_room(); // what the mark took, before the file comes back
    result.files = model.patched_files(result.marked.positions, options.output_name, options.normals);
    model.let_bytes_go();
    TriangleMesh written = model.reread(result.files);
    if (!is_same_surface(written, model.mesh())) {
        result.marked.positions = kept_apart(model, std::move(result.marked.positions));
        result.files = model.patched_files(result.marked.positions, options.output_name, options.normals);
        written = model.reread(result.files);
    }
    make_room();
    const VerifyOptions check = self_check_options(options.mark, result.marked.ambiguity);
    const Suspect suspect = prepare_suspect(written, check.vertices, progress);
    const Marked& marked = result.marked;
    std::vector<Rehearsed> rehearsed;
    parallel_invoke(
        [&] {
            Sequences sequences(key.secret(), marked.rmax);
            rehearsed = rehearse(suspect, marked.frame, sequences, marked.level, marked.rmax);
        },
        [&] { result.check = self_check(suspect, marked, key, check, progress); });
    if (result.check.verdict == detect::Verdict::present) {
        if (!is_readable(result.check, key, options.mark))
            result.loss = Loss::content;
        result.rehearsed = paid_for(std::move(rehearsed), result.check.score.hypotheses);
    } else {
        result.loss =
            lost_in_storage(result, model.mesh(), key, check, progress) ? Loss::storage : Loss::power;
    }
    return result;
}

} // namespace

MarkedModel mark_model(const io::Model& model, const key::Key& key, const MarkModelOptions& asked,
                       const Progress& progress) {
    MarkModelOptions options = asked;
    MarkedModel result = mark_once(model, key, options, progress);
    if (const payload::Content& content = options.mark.content;
        result.loss == Loss::power && content.copy && !content.message) {
        options.mark.shares = payload::shares_of_weak_copies;
        result = mark_once(model, key, options, progress);
    }
    if (result.loss == Loss::power)
        lies_too_far(model, result);
    if (result.loss != Loss::none && result.remedy.empty())
        result.remedy = remedy(model, key, options, result, progress);
    return result;
}

std::string describe_loss(const MarkedModel& result, double pf) {
    if (result.loss == Loss::content)
        return fmt::format(
            "nothing was written, because what the mark says could not be read back (the mark itself is "
            "found with log10 p {:.1f}); {}",
            result.check.score.log10_p, result.remedy);
    if (result.loss == Loss::visibility || result.loss == Loss::distance)
        return "nothing was written, because " + result.remedy;
    return fmt::format(
        "nothing was written, because the mark would not be found again (log10 p {:.1f}, {:.1f} is needed); "
        "{}",
        result.check.score.log10_p, std::log10(pf),
        result.loss == Loss::power
            ? fmt::format("with {} vertices the mesh is too small, too plain or too symmetric for a mark of "
                          "MSDM2 {:.2g}; {}",
                          result.marked.positions.size(), result.marked.msdm2.value_or(0), result.remedy)
            : "the file's coordinates are too coarse for it; " + result.remedy);
}

resync::Receipt make_receipt(const io::Model& model, const MarkedModel& result, const key::Key& key,
                             const Progress& progress) {
    return make_receipt(model.mesh(), result.marked, key, model.bytes(), result.files.bytes, progress);
}

void require_same_format(io::Format in, io::Format out, std::string_view output) {
    if (in != out)
        throw ParameterError(
            fmt::format("{}: mark keeps the file as it is but for its coordinates, so the output has to be "
                        "a .{} like the input; convert it before or afterwards",
                        output, io::name_of(in)));
}

MarkedFile mark_file(const std::filesystem::path& in, const std::filesystem::path& out, const key::Key& key,
                     const MarkFileOptions& options, const Progress& progress) {
    const io::WriteOptions writing{.overwrite = options.overwrite};
    io::require_writable(out, writing);
    if (!options.receipt.empty())
        io::require_writable(options.receipt, writing);
    const io::Format format = format_of(in, options.format);
    require_same_format(format, format_of(out, options.format), out.string());
    const io::Model model = io::read(in, {.format = format});

    MarkedModel result = mark_model(model, key, {options.mark, options.normals, out.string()}, progress);
    MarkedFile report{result.loss == Loss::none, {}, {}, result.check, result.rehearsed};
    if (report.written) {
        io::FileSet files(writing);
        io::add_files(files, out, result.files);
        if (!options.receipt.empty()) // last: it speaks of files that are there
            files.add(options.receipt, resync::to_text(make_receipt(model, result, key, progress)));
        files.commit();
    } else {
        report.reason = fmt::format("{}: {}", in.string(), describe_loss(result, options.mark.pf));
    }
    report.marked = std::move(result.marked);
    return report;
}

} // namespace wm3d::watermark
