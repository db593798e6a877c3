// SPDX-License-Identifier: GPL-3.0-or-later
#include "bindings.hpp"

#include <cmath>
#include <optional>

#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

namespace wm3d::python {

namespace {

using Path = std::filesystem::path;

/// The keyword arguments that all ways of marking share.
struct MarkKeywords {
    std::optional<double> visibility, strength, gamma;
    std::optional<std::string> profile, payload;
    std::optional<std::size_t> vertices;
    std::optional<unsigned> level;
    std::optional<double> rmax;
    double pf;
};

void require_probability(double pf) {
    if (!(pf > 0 && pf < 1))
        throw ParameterError(fmt::format("pf {} is not a probability between 0 and 1, such as 1e-6", pf));
}

void require_positive(std::optional<double> value, std::string_view name) {
    if (value && !(*value > 0 && std::isfinite(*value)))
        throw ParameterError(fmt::format("{} {} is not a number above 0", name, *value));
}

/// The value of some names; the first is the default.
template<typename Value>
Value named(const std::optional<std::string>& name, std::string_view what,
            std::initializer_list<std::pair<std::string_view, Value>> values) {
    if (!name)
        return values.begin()->second;
    std::string names;
    for (const auto& [known, value] : values) {
        if (known == *name)
            return value;
        names += fmt::format("{}{}", names.empty() ? "" : ", ", known);
    }
    throw ParameterError(fmt::format("{} '{}' is none of {}", what, *name, names));
}

MarkOptions options_of(const MarkKeywords& given) {
    require_probability(given.pf);
    require_positive(given.visibility, "visibility");
    require_positive(given.strength, "strength");
    require_positive(given.gamma, "gamma");
    require_positive(given.rmax, "rmax");
    if (given.visibility.has_value() + given.strength.has_value() + given.gamma.has_value() > 1)
        throw ParameterError("visibility, strength and gamma exclude each other; give one of them");
    using watermark::Profile;
    MarkOptions options;
    options.profile =
        named<Profile>(given.profile, "profile",
                       {{"masked", Profile::masked}, {"robust", Profile::robust}, {"paper", Profile::paper}});
    options.visibility = given.visibility.value_or(options.visibility);
    options.strength = given.strength;
    if (given.payload)
        options.content.message = payload::parse_message(*given.payload);
    options.vertices = given.vertices.value_or(options.vertices);
    options.gamma = given.gamma;
    options.level = given.level;
    options.rmax = given.rmax;
    options.pf = given.pf;
    return options;
}

py::dict mark_arrays(const py::array& vertices, const py::array& faces, const Key& key,
                     std::optional<double> visibility, std::optional<double> strength,
                     std::optional<double> gamma, std::optional<std::string> profile,
                     std::optional<std::string> payload, std::optional<std::size_t> base_vertices,
                     std::optional<unsigned> level, std::optional<double> rmax, double pf,
                     const py::object& progress) {
    const MarkOptions options =
        options_of({visibility, strength, gamma, profile, payload, base_vertices, level, rmax, pf});
    const TriangleMesh mesh = mesh_of(vertices, faces);
    const Progress tell = progress_of(progress);
    const Marked marked = [&] {
        const py::gil_scoped_release unlocked;
        return mark(mesh, key, options, tell);
    }();
    return marked_fields(marked);
}

py::dict verify_arrays(const py::array& vertices, const py::array& faces, const Key& key, double pf,
                       const std::optional<Path>& receipt,
                       const std::optional<std::pair<py::array, py::array>>& reference,
                       const std::optional<std::string>& search, double effort,
                       std::optional<std::size_t> base_vertices, const py::object& progress) {
    require_probability(pf);
    using watermark::SearchUse;
    VerifyOptions options;
    options.pf = pf;
    options.search = named<SearchUse>(search, "search",
                                      {{"when_needed", SearchUse::when_needed},
                                       {"never", SearchUse::never},
                                       {"always", SearchUse::always}});
    if (!(effort >= 0 && std::isfinite(effort)))
        throw ParameterError(fmt::format("effort {} is not a number from 0", effort));
    options.effort = effort;
    options.vertices = base_vertices.value_or(options.vertices);
    std::optional<resync::Receipt> kept;
    if (receipt) {
        kept = resync::parse_receipt(io::read_file(*receipt), receipt->string());
        options.receipt = &*kept;
        options.align_receipt = resync::has_registration();
    }
    const TriangleMesh mesh = mesh_of(vertices, faces);
    const TriangleMesh original = reference ? mesh_of(reference->first, reference->second) : TriangleMesh{};
    if (reference)
        options.reference = &original;
    const Progress tell = progress_of(progress);
    const VerifyReport report = [&] {
        const py::gil_scoped_release unlocked;
        return verify(mesh, key, options, tell);
    }();
    return report_fields(report);
}

py::dict mark_files(const Path& in, const Path& out, const Key& key, std::optional<double> visibility,
                    std::optional<double> strength, std::optional<double> gamma,
                    std::optional<std::string> profile, std::optional<std::string> payload,
                    std::optional<std::size_t> base_vertices, std::optional<unsigned> level,
                    std::optional<double> rmax, double pf, const std::optional<Path>& receipt, bool overwrite,
                    const py::object& progress) {
    MarkFileOptions options;
    options.mark =
        options_of({visibility, strength, gamma, profile, payload, base_vertices, level, rmax, pf});
    options.receipt = receipt.value_or(Path());
    options.overwrite = overwrite;
    const Progress tell = progress_of(progress);
    const MarkedFile result = [&] {
        const py::gil_scoped_release unlocked;
        return mark_file(in, out, key, options, tell);
    }();
    py::dict fields;
    fields["written"] = result.written;
    fields["reason"] = result.reason;
    fields["marked"] = marked_fields(result.marked);
    fields["check"] = report_fields(result.check);
    return fields;
}

py::tuple read_arrays(const Path& path, const std::optional<std::string>& format) {
    io::ReadOptions options;
    if (format && !(options.format = io::format_of_name(*format)))
        throw ParameterError(fmt::format("'{}' is none of obj, ply, stl, off, gltf, glb", *format));
    const io::Model model = [&] {
        const py::gil_scoped_release unlocked;
        return io::read(path, options);
    }();
    return py::make_tuple(array_of(model.mesh().positions), array_of(model.mesh().triangles),
                          io::name_of(model.format()));
}

} // namespace

Progress progress_of(const py::object& callable) {
    return [function = py::handle(callable)](std::string_view stage, double done) {
        const py::gil_scoped_acquire locked;
        if (PyErr_CheckSignals() != 0)
            throw py::error_already_set();
        if (!function.is_none())
            function(stage, done);
    };
}

void bind_calls(py::module_& module) {
    const py::arg_v pf("pf", watermark::default_pf);
    const py::arg_v visibility("visibility", py::none()), profile("profile", py::none()),
        payload("payload", py::none());
    const py::arg_v strength("strength", py::none()), gamma("gamma", py::none()), level("level", py::none()),
        rmax("rmax", py::none()), base_vertices("base_vertices", py::none()),
        progress("progress", py::none());
    module.def("mark", mark_arrays, py::arg("V"), py::arg("F"), py::arg("key"), py::kw_only(), visibility,
               strength, gamma, profile, payload, base_vertices, level, rmax, pf, progress);
    module.def("verify", verify_arrays, py::arg("V"), py::arg("F"), py::arg("key"), py::kw_only(), pf,
               py::arg("receipt") = py::none(), py::arg("reference") = py::none(),
               py::arg("search") = py::none(), py::arg("effort") = 1.0, base_vertices, progress);
    module.def("mark_file", mark_files, py::arg("source"), py::arg("target"), py::arg("key"), py::kw_only(),
               visibility, strength, gamma, profile, payload, base_vertices, level, rmax, pf,
               py::arg("receipt") = py::none(), py::arg("overwrite") = false, progress);
    module.def("read", read_arrays, py::arg("path"), py::arg("format") = py::none());
}

} // namespace wm3d::python
