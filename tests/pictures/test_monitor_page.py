"""The results monitor in a browser."""

from __future__ import annotations

from pathlib import Path

from browser import running

from dalembert.resultsMonitor import PageMonitor, Plots


def test_the_page_draws_received_frames() -> None:
    Path("a.txt").write_text("0,1,-1\n1,3,2\n")
    page = PageMonitor(Plots("a.txt", [0, 1], [1, 2]))
    try:
        with running() as browser:
            tab = browser.tab(page.server.address)
            tab.wait("page.updates === 1 && page.plots.length === 2")
            assert tab.value("[document.title, page.state.textContent]") == ["a.txt", "2 rows"]
            assert tab.value("page.plots[1].drawn[0].map((point) => point.slice(2))") == [[1, -1], [3, 2]]
            with open("a.txt", "a") as more:
                more.write("2,5,nan\n3,5,7\n")
            assert page.update() and not page.update()
            tab.wait("page.updates === 2 && page.state.textContent === '4 rows'")
            assert tab.value("page.plots[1].drawn[0].map((point) => point.slice(2))") == [[1, -1], [3, 2], [5, 7]]
            x, y = tab.value(
                "(() => { const p = page.plots[0], b = p.canvas.getBoundingClientRect(); return [p.drawn[0][1][0] + b.left, p.drawn[0][1][1] + b.top]; })()"
            )
            tab.call("Input.dispatchMouseEvent", type="mouseMoved", x=x + 2, y=y)
            tab.wait("page.plots[0].told === '1, 3'")
            assert tab.errors == []
            assert {r.split("#")[0].partition(f":{page.server.port}")[2] for r in tab.requests} <= {
                "",
                "/",
                "/bundle.js",
                "/socket",
            }
            tab.close()
    finally:
        page.server.stop()
