"""The page of a subdivided cage: its mesh, and what is proved of it; of a cage and another object, how far they are apart."""
import json

CUBE = "".join(f"v {x} {y} {z}\n" for z in (0, 1) for y in (0, 1) for x in (0, 1)) + "".join(
    f"f {face}\n" for face in ["1 3 4 2", "5 6 8 7", "1 2 6 5", "2 4 8 6", "4 3 7 8", "3 1 5 7"])


def check_subdivided(checks, browser):
    (checks.folder / "cage.obj").write_text(CUBE)
    report = json.loads(checks.run("subdivide", "cage.obj", "--within", "0.05", "--json", "--html", "subdivided.html"))
    checks.opened(browser, "subdivided.html")
    browser.value("toccata.choose(0)")
    told = browser.value("document.getElementById('sentence').textContent + document.getElementById('facts').textContent")
    checks.expect("from the limit surface." in told and f"{len(report['triangles']):,} triangles" in told, f"of the mesh is told: {told}")
    checks.expect("a closed cage of 6 faces" in told and "proved" in told, f"of the cage is told: {told}")
    checks.run("subdivide", "cage.obj", "gen:box", "--pose-b", *"1 0 0 0 1 0 0 0 1 5 0.5 0.5".split(), "--html", "gap.html")
    checks.opened(browser, "gap.html")
    rows = browser.value("[...document.querySelectorAll('#finding-list .row')].map((row) => row.textContent)")
    checks.expect(len(rows) == 1 and "apart" in rows[0], f"the distance is listed: {rows}")
    checks.quiet(browser, "subdivided")
