// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Results of a bench that was never run.
#pragma once

#include <wm3d/study/bench.hpp>

namespace wm3d::study {

inline BenchItem found(double log10_p) {
    BenchItem item;
    item.log10_p = log10_p;
    return item;
}

inline MarkName mark_name(const std::string& model, const MarkSize& size, std::size_t key) {
    MarkName name;
    name.model = model;
    name.size = size;
    name.key = key;
    return name;
}

inline ItemName item_name(const MarkName& mark, const std::string& attack) {
    ItemName name;
    name.mark = mark;
    name.attack = attack;
    return name;
}

/// Two models, two keys, three attacks.
inline BenchResults example() {
    BenchResults results;
    const MarkSize size{MarkSize::Unit::mrms, 0.02};
    for (const char* model : {"b.ply", "a.obj"}) {
        results.models[model] = {"0123456789abcdef", 1000, 2000, ""};
        for (std::size_t key : {0u, 1u}) {
            const MarkName mark = mark_name(model, size, key);
            results.marks[mark] = {0.021, 0.03, 0.021, 0.018 + 0.001 * static_cast<double>(key),
                                   0.2,   0.19, ""};
            results.items[item_name(mark, "noise:0.3")] = found(key == 0 ? -20 : -4);
            results.items[item_name(mark, "bend:5+noise:0.3")] = found(-30);
            results.items[item_name(mark, "file")] = found(-50);
        }
    }
    BenchItem failed;
    failed.error = "nothing is left";
    results.items[item_name(mark_name("b.ply", size, 0), "cropping:50")] = failed;
    results.models["c.stl"] = {"", 0, 0, "c.stl: no mesh"};
    return results;
}

inline BenchSetting example_setting() {
    BenchSetting setting;
    setting.sizes = {{MarkSize::Unit::mrms, 0.02}};
    return setting;
}

} // namespace wm3d::study
