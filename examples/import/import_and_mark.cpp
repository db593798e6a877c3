// SPDX-License-Identifier: GPL-3.0-or-later
// Marks the sample and looks for the mark; nothing of wm3d is included.
#include <cstdio>

import wm3d;
import wm3d.shapes;

int main() {
    const wm3d::Key key = wm3d::Key::generate("example"), stranger = wm3d::Key::generate("somebody else");
    const wm3d::TriangleMesh original = wm3d::shapes::sample(30000, 1);

    wm3d::MarkOptions options;
    options.strength = 0.05; // root mean square move along the normals, % of the bounding box's diagonal
    const wm3d::Marked marked = wm3d::mark(original, key, options);
    const wm3d::TriangleMesh copy{marked.positions, original.triangles};

    const wm3d::VerifyReport mine = wm3d::verify(copy, key), theirs = wm3d::verify(copy, stranger);
    std::printf("the owner: log10 p = %.1f; a stranger: %.1f\n", mine.score.log10_p, theirs.score.log10_p);
    return mine.verdict == wm3d::Verdict::present && theirs.verdict == wm3d::Verdict::absent ? 0 : 1;
}
