#!/usr/bin/python3
"""The page of `starling report` as a user meets it, in headless Chromium.

usage: test_report.py PROGRAM SOURCE_DIR SCENARIO
"""
import inspect
import pathlib
import re
import sys
import tempfile
import time

sys.dont_write_bytecode = True
import browser  # noqa: E402
from test_app import (COARSE, SHORT, SKIPPED, SOURCE, expect, expect_exit, rows_of,  # noqa: E402
                      starling, summary_of, wait_for)

FRAMES = ["--set", "output.wall_every=0.05", "--set", "output.fluid_every=0.05"]
LARGEST_PAGE = 20e6  # bytes


def report(out, *words):
    """Writes the page of a run, which says so with these words."""
    result = starling("report", out)
    if "built without the page" in result.stderr:
        print("skipped: this build has no page: npm was not there or failed")
        sys.exit(SKIPPED)
    expect_exit(result, 0)
    page = out / "report.html"
    for text in (str(page), *words):
        expect(text in result.stdout, "report does not say", text, "\n", result.stdout)
    expect(page.stat().st_size < LARGEST_PAGE, "a page of", page.stat().st_size, "bytes")
    return page


def check_sound(page):
    errors = page.errors()
    expect(errors == [], "the browser complains:", errors)
    expect(page.requests() == [], "the page asks for", page.requests())
    expect(page.run("return Boolean(window.starling)"), "the page's script did not finish")


def columns_of(path):
    rows = rows_of(path)
    return {title.split(" [")[0]: [float(row[n]) for row in rows[1:]]
            for n, title in enumerate(rows[0])}


def check_plot(page, key, columns, names):
    """A plot's first lines are these columns of the CSV, the first being its horizontal axis."""
    data = page.run("return window.starling.plots[arguments[0]].data.map(d => Array.from(d))", key)
    for name, drawn in zip(names, data):
        expected = columns[name]
        expect(len(drawn) == len(expected) > 2, key, name, len(drawn), "points")
        for a, b in zip(drawn, expected):
            expect(a is not None and abs(a - b) <= 2e-7 * abs(b) + 1e-30, key, name, a, "is not", b)


def plain(text):
    """A number as the page writes it."""
    return float(re.match(r"−?[\d.]+", text)[0].replace("−", "-"))


def check_numbers(page, summary):
    """The table of results beside theory."""
    rows = page.run("return [...document.querySelectorAll('#results tbody tr')]"
                    ".map(r => [...r.children].map(c => c.textContent))")
    table = {row[0]: row[1:] for row in rows}
    flow = table["Flow rate half way, Q"]
    for shown, expected in ((flow[0], summary["Q_mid"]), (flow[1], summary["theory"]["Q_1d"])):
        expect(abs(plain(shown) - expected) < 1e-4 * abs(expected), shown, "is not", expected)
    difference = 100 * summary["theory"]["Q_relative_difference"]
    expect(abs(plain(flow[2].replace("+", "")) - difference) < 0.06 * abs(difference),
           flow, difference)


def positions(page):
    return page.run("return Array.from(window.starling.viewer.wall.points)")


def check_time(page, frames):
    """The slider moves the wall and the flow, the section and the words; play goes on by itself."""
    last, drawn, words = positions(page), page.picture(".canvas canvas"), page.text("#time-text")
    expect(f"frame {frames} of {frames}" in words, words)
    section = page.run("return document.querySelector('.side .now').getAttribute('d')")
    page.set("#time", 0)
    expect(f"t = 0 R₀/U_c (step 0, frame 1 of {frames})" in page.text("#time-text"),
           page.text("#time-text"))
    moved = max(abs(a - b) for a, b in zip(last, positions(page)))
    expect(moved > 0.01, "the slider moves the wall by", moved)
    expect(page.picture(".canvas canvas") != drawn, "another time looks the same")
    expect(page.run("return document.querySelector('.side .now').getAttribute('d')") != section,
           "the section stays the same")
    page.click("#play")
    wait_for(lambda: page.run("return document.getElementById('time').value") == str(frames - 1))
    expect(positions(page) == last, "the end of the film is not the last frame")
    expect(page.picture(".canvas canvas") == drawn, "the end of the film looks different")
    expect("Play" in page.text("#play"), "the film has ended, but plays", page.text("#play"))
    page.click("#play")
    page.set("#time", 1)
    expect("Play" in page.text("#play"), "a film plays on from a chosen time")


def check_shared_time(page, frames):
    """Plots over time mark the time of the view; a click in one sets it."""
    from selenium.webdriver.common.action_chains import ActionChains
    plot = page.driver.find_element("css selector", "#over-time .u-over")
    page.run("arguments[0].scrollIntoView({block: 'center'})", plot)
    page.set("#time", frames - 1)
    marked = page.picture("#over-time canvas")
    page.set("#time", 0)
    expect(page.picture("#over-time canvas") != marked, "the plot marks no time")
    ActionChains(page.driver).move_to_element(plot).click().perform()
    times = page.run("return window.starling.run.wall.frames.map(f => f.t)")
    middle = page.run("const {min, max} = window.starling.plots.flow.scales.x;"
                      "return (min + max) / 2")
    nearest = min(range(frames), key=lambda n: abs(times[n] - middle))
    shown = page.run("return Number(document.getElementById('time').value)")
    expect(0 < nearest < frames - 1 and shown == nearest, "a click shows frame", shown, nearest)


def check_points(page, out):
    """The wall of the last frame is the one that `starling export` writes."""
    expect_exit(starling("export", out, "--out", out / "wall.csv"), 0)
    wall = columns_of(out / "wall.csv")
    expected = [value for point in zip(wall["x"], wall["y"], wall["z"]) for value in point]
    expect(positions(page) == expected, "other points")
    field = page.run("const f = window.starling.run.wall.fields.find(f => f.name === 'tau1');"
                     "return [f.low, f.high, f.unit]")
    expect(field[0] <= min(wall["tau1"]) and field[1] >= max(wall["tau1"]) - 1e-6, field)
    expect(field[2] == "rho U_c^2 R_0", field)


def check_colours(page):
    """Each field has colours and limits of its own."""
    seen = []
    labels = page.run("return [...document.getElementById('wall-field').options].map(o => o.text)")
    expect(len(labels) == 4, labels)
    for n, label in enumerate(labels):
        page.set("#wall-field", n, "change")
        expect(label in page.text("#wall-bar"), label, "is not on the bar", page.text("#wall-bar"))
        seen.append(page.picture(".canvas canvas"))
    page.set("#flow-field", 2, "change")
    expect("flow: pressure" in page.text("#flow-bar"), page.text("#flow-bar"))
    seen.append(page.picture(".canvas canvas"))
    for n in (1, 2):  # half of the wall, all of it
        page.set("#cut", n, "change")
        seen.append(page.picture(".canvas canvas"))
    page.run("[...document.querySelectorAll('.views button')].at(-1).click()")
    seen.append(page.picture(".canvas canvas"))
    expect(len(set(seen)) == len(seen), "some choices change nothing")


def check_turning(page):
    from selenium.webdriver.common.action_chains import ActionChains
    canvas = page.driver.find_element("css selector", ".canvas canvas")
    before = page.picture(".canvas canvas")
    ActionChains(page.driver).move_to_element(canvas).click_and_hold().move_by_offset(
        120, 40).release().perform()
    wait_for(lambda: page.picture(".canvas canvas") != before)


def test_page(directory):
    out = directory / "out"
    expect_exit(starling("run", *SHORT, *FRAMES, "--set", "title=</script>Tube & <b>wall</b>",
                         "--set", "stop.steps=12", "--out", out), 0)
    with browser.opened(report(out)) as page:
        check_sound(page)
        expect(page.text("h1") == "</script>Tube & <b>wall</b>", page.text("h1"))
        summary, series = summary_of(out), columns_of(out / "series.csv")
        check_numbers(page, summary)
        check_plot(page, "flow", series, ["t", "Q_in", "Q_mid", "Q_out"])
        check_plot(page, "radius", series, ["t", "R_max", "R_min"])
        check_plot(page, "leak", series, ["t", "dV_dt", "leak"])
        profile = columns_of(out / "profile.csv")
        check_plot(page, "profile-radius", profile, ["x", "R_mean", "R_min", "R_max"])
        check_plot(page, "profile-pressure", profile, ["x", "P_centre", "P_transmural"])
        check_points(page, out)
        check_time(page, page.run("return window.starling.run.wall.frames.length"))
        check_shared_time(page, page.run("return window.starling.run.wall.frames.length"))
        check_colours(page)
        check_turning(page)
        check_sound(page)
        expect('law = "hooke"' in page.text("#case-text pre"), page.text("#case-text pre"))
        for library in ("three", "uplot"):
            expect(library in page.text("#more"), "no licence of", library)
    before = (out / "report.html").read_bytes()
    expect(report(out).read_bytes() == before, "the same run makes another page")


def test_flow(directory):
    """Flow of the last time alone is not shown at others; so in a slice normal to y."""
    out = directory / "out"
    expect_exit(starling("run", *SHORT, *FRAMES[:2], "--set", "output.fluid_region=plane_y",
                         "--out", out), 0)
    with browser.opened(report(out)) as page:
        check_sound(page)
        visible = "return window.starling.viewer.flow.object.visible"
        inside = page.run("const p = window.starling.viewer.flow.texture.image.data;"
                          "let n = 0; for (let i = 3; i < p.length; i += 4) n += p[i] > 0;"
                          "return 4 * n / p.length")
        expect(0.3 < inside < 0.6, "the tube fills", inside, "of the plane")  # 2 of 4.7 wide
        expect(page.run(visible) is True, "the last flow is not shown")
        page.set("#time", 0)
        expect(page.run(visible) is False, "flow at a time that has none")
        expect("no frame of the flow" in page.text("#time-text"), page.text("#time-text"))


def test_collapse(directory):
    out = directory / "out"
    expect_exit(starling("run", SOURCE / "cases" / "collapse_mode3.toml", "--set",
                         "grid.spacing=0.25", "--set", "stop.end_time=3", "--out", out), 0)
    with browser.opened(report(out)) as page:
        check_sound(page)
        check_plot(page, "area", columns_of(out / "series.csv"), ["t", "min_area_ratio"])
        words = page.text("#results")
        for text in ("Lobes", "Smallest gap", "linear theory of buckling"):
            expect(text in words, "no", text, "in", words)


def test_si(directory):
    """Numbers in SI are drawn with prefixes; the data stay those of the files."""
    out = directory / "out"
    expect_exit(starling("run", SOURCE / "cases" / "microchannel_si.toml", "--set",
                         "grid.spacing=0.1 mm", "--set", "stop.steps=30", "--out", out), 0)
    with browser.opened(report(out)) as page:
        check_sound(page)
        check_plot(page, "flow", columns_of(out / "series.csv"), ["t", "Q_in"])
        axes = page.run("return window.starling.plots.radius.axes.map(a => a.label)")
        expect(axes[1] in ("R [µm]", "R [mm]"), axes)
        expect(re.search(r"wall: displacement \[[µm]?m\]", page.text("#wall-bar")),
               page.text("#wall-bar"))


def test_breakdown(directory):
    out = directory / "out"
    expect_exit(starling("run", *COARSE, "--set", "time.step=3", "--set", "stop.steps=1000",
                         "--out", out), 3)
    with browser.opened(report(out)) as page:
        check_sound(page)
        expect("broke down" in page.text("#state"), page.text("#state"))
        expect("a smaller time step" in page.text("#notes"), page.text("#notes"))
        expect("where it broke down" in page.text("#viewer"), "the place is not shown")


def test_unfinished(directory):
    """After a kill, damaged, without frames: a page of what is there, saying what is not."""
    out = directory / "out"
    expect_exit(starling("run", *SHORT, *FRAMES, "--out", out), 0)
    (out / "summary.json").unlink()
    (out / "profile.csv").unlink()
    (out / "theory.csv").write_text("")
    series = (out / "series.csv").read_text()
    (out / "series.csv").write_text(series[:-30])  # the last row is cut
    frame = out / "frames" / "wall_000001.h5"
    frame.write_bytes(frame.read_bytes()[:900])
    with browser.opened(report(out, "frames/wall_000001.h5 is left out")) as page:
        check_sound(page)
        expect("has not ended" in page.text("#state"), page.text("#state"))
        expect("wall_000001.h5 is left out" in page.text("#notes"), page.text("#notes"))
        expect("theory.csv is not shown" in page.text("#notes"), page.text("#notes"))
        expect("the rows before it are shown" in page.text("#notes"), page.text("#notes"))
        drawn = page.run("return window.starling.plots.flow.data[0].length")
        expect(drawn == len(series.splitlines()) - 2, drawn, "rows are drawn")
        expect("Flow rate half way" in page.text("#results"), page.text("#results"))
        expect(page.text("#along-tube") == "", "a profile from nowhere")
    (out / "series.csv").write_text(series)
    (out / "case.toml").unlink()
    (out / "summary.json").write_text("{}")
    for file in (out / "frames").iterdir():
        file.unlink()
    for name in ("wall", "fluid"):
        (out / f"{name}.xdmf").unlink()
    with browser.opened(report(out)) as page:
        check_sound(page)
        expect("no frames" in page.text("#viewer"), page.text("#viewer"))
        for text in ("case.toml is missing", "summary.json is left out"):
            expect(text in page.text("#notes"), "no", text, "in", page.text("#notes"))
        check_plot(page, "flow", columns_of(out / "series.csv"), ["t", "Q_in"])


def test_no_webgl(directory):
    """A browser without WebGL shows all but the 3-D view, and says why."""
    out = directory / "out"
    expect_exit(starling("run", *SHORT, *FRAMES, "--out", out), 0)
    with browser.opened(report(out), "--disable-3d-apis") as page:
        expect("no WebGL" in page.text("#viewer"), page.text("#viewer"))
        expect(page.run("return !document.querySelector('.canvas')"), "an empty view is left")
        check_plot(page, "flow", columns_of(out / "series.csv"), ["t", "Q_in"])
        expect(page.requests() == [], page.requests())


def main():
    scenarios = {name[5:]: function for name, function in globals().items()
                 if name.startswith("test_") and inspect.isfunction(function)}
    if browser.missing():
        print("skipped: not installed:", browser.missing())
        sys.exit(SKIPPED)
    with tempfile.TemporaryDirectory() as directory:
        scenarios[sys.argv[3]](pathlib.Path(directory))


if __name__ == "__main__":
    main()
