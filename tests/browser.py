#!/usr/bin/env python3
"""The page that `analyze --plot` writes, as a browser shows it. browser.py WM3D TestClass"""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

WM3D = None
MODEL = ("analyze", "--sigma-r2", "0.032", "--delta-range", "0.1", "--gamma", "0.1,0.2", "--vertices", "2500,10000",
         "--pf-range", "1e-12:0.5:20")

# Run by the page itself: what is drawn, as the browser laid it out.
PROBE = """<pre id="probe"></pre><script>
window.addEventListener("load", () => {
  const svg = document.querySelector("#figure svg"), box = svg.getBoundingClientRect();
  const curves = [...svg.querySelectorAll("g[id^=gnuplot_plot_]")].filter(g => {
    const b = g.getBoundingClientRect();
    return b.width > 0.2 * box.width && b.height > 0.01 * box.height;
  });
  const data = JSON.parse(document.getElementById("data").textContent);
  document.getElementById("probe").textContent = JSON.stringify({
    figure_width: box.width, figure_height: box.height, curves: curves.length,
    text: [...svg.querySelectorAll("text")].map(t => t.textContent.trim()).join("|"),
    points: data.predicted.length, rows: document.querySelectorAll("tbody tr").length,
    overflow: document.documentElement.scrollWidth - document.documentElement.clientWidth});
});</script>"""


def browser():
    return next((path for name in ("chromium", "chromium-browser", "google-chrome") if (path := shutil.which(name))),
                None)


class Page(unittest.TestCase):
    def setUp(self):
        if browser() is None or shutil.which("gnuplot") is None:
            print("SKIPPED: chromium and gnuplot are needed to look at a page")
            self.skipTest("no browser")
        temporary = tempfile.TemporaryDirectory(prefix="wm3d-browser-", ignore_cleanup_errors=True)
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    def shown(self, page):
        """The document after its scripts have run."""
        command = [browser(), "--headless", "--no-sandbox", "--disable-gpu", "--no-first-run",
                   "--disable-background-networking", "--disable-component-update", "--disable-sync",
                   f"--user-data-dir={self.folder / 'profile'}", "--window-size=1200,900", "--dump-dom", page.as_uri()]
        return subprocess.run(command, capture_output=True, text=True, timeout=120, check=True).stdout

    def test_every_curve_is_drawn_and_named(self):
        import html
        import json
        page = self.folder / "roc.html"
        subprocess.run([WM3D, *MODEL, "-q", "--plot", page], check=True, capture_output=True, timeout=60)
        text = page.read_text()
        self.assertNotRegex(re.sub(r'xmlns(:\w+)?="[^"]*"', "", text), r"(src|href)=\"https?:")
        probed = self.folder / "probed.html"
        probed.write_text(text.replace("</body>", PROBE + "</body>"))
        found = re.search(r'<pre id="probe">(.*?)</pre>', self.shown(probed), re.DOTALL)
        probe = json.loads(html.unescape(found.group(1)))
        self.assertEqual(probe["curves"], 4)
        self.assertGreater(probe["figure_width"], 600)
        self.assertGreater(probe["figure_height"], 300)
        for label in ("P_f", "P_m", "n = 2500", "n = 10000", "γ = 0.2"):
            self.assertIn(label, probe["text"])
        self.assertEqual(probe["points"], 80)
        self.assertEqual(probe["rows"], 20)
        self.assertLessEqual(probe["overflow"], 0)


if __name__ == "__main__":
    WM3D = pathlib.Path(sys.argv.pop(1)).resolve()
    unittest.main(verbosity=2)
