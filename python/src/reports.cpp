// SPDX-License-Identifier: GPL-3.0-or-later
#include "bindings.hpp"

namespace wm3d::python {

namespace {

std::string_view name_of(watermark::Doubt doubt) {
    switch (doubt) {
    case watermark::Doubt::power:
        return "power";
    case watermark::Doubt::alignment:
        return "alignment";
    case watermark::Doubt::opening:
        return "opening";
    case watermark::Doubt::vertices:
        return "vertices";
    case watermark::Doubt::axes:
        return "axes";
    case watermark::Doubt::none:
        break;
    }
    return "none";
}

} // namespace

py::dict marked_fields(const Marked& marked) {
    const embed::Distortion percent = watermark::percent(marked.distortion, marked.diagonal);
    py::dict fields;
    fields["vertices"] = array_of(marked.positions);
    fields["profile"] = watermark::name(marked.profile);
    fields["base_vertices"] = marked.base_vertices;
    fields["level"] = marked.level;
    fields["rmax"] = marked.rmax;
    fields["gamma"] = marked.gamma;
    fields["rms_percent"] = percent.normal_rms;
    fields["vertex_rms_percent"] = percent.vertex_rms;
    fields["max_percent"] = percent.max;
    fields["msdm2"] = marked.msdm2 ? py::object(py::float_(*marked.msdm2)) : py::none();
    return fields;
}

py::dict report_fields(const VerifyReport& report) {
    py::dict fields;
    fields["verdict"] = detect::name(report.verdict);
    fields["log10_p"] = report.score.log10_p;
    fields["hypotheses"] = report.score.hypotheses;
    fields["bound"] = report.score.bound;
    fields["sigmas"] = report.score.best.sigmas;
    fields["doubt"] = name_of(report.doubt);
    fields["level"] = report.level;
    fields["pose"] = report.pose_origin;
    fields["base_vertices"] = report.base_vertices;
    fields["largest_opening_percent"] = 100 * report.largest_opening;
    fields["expected_sigmas"] = report.expected_sigmas;
    fields["predicted_miss"] = report.predicted_miss;
    fields["by_difference"] = report.by_difference;
    fields["payload"] = py::none();
    fields["payload_log10_p"] = py::none();
    if (report.payload) {
        fields["payload"] = payload::to_argument(report.payload->message);
        fields["payload_log10_p"] = report.payload->log10_p;
    }
    return fields;
}

} // namespace wm3d::python
