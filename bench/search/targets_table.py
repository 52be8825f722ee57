"""targets_table.py OUT NAME...: prints the table of bench/search/targets from its results."""
import json
import statistics
import sys

out, names = sys.argv[1], sys.argv[2:]
print("| study | search | runs fine, coarse | particle-steps, median | hypervolume, median | worst | fewer steps | hypervolume kept |")
print("|---|---|---:|---:|---:|---:|---:|---:|")
for name in names:
    found = {}
    for search in ("old", "new"):
        with open(f"{out}/{name}.{search}.json", encoding="utf-8") as file:
            rows = json.load(file)["rows"]
        found[search] = {
            "steps": statistics.median(row["particle_steps"] for row in rows),
            "volume": statistics.median(row["hypervolume"] for row in rows),
            "worst": min(row["hypervolume"] for row in rows),
            "runs": [statistics.median(row["runs"][k] for row in rows) for k in (0, 1)],
        }
    for search, one in found.items():
        ratio = kept = ""
        if search == "new":
            ratio = f"{found['old']['steps'] / one['steps']:.1f} times (asked: 3)"
            kept = f"{100 * one['volume'] / found['old']['volume']:.1f} % (asked: 98)"
        print(f"| `{name}` | {search} | {one['runs'][0]:g}, {one['runs'][1]:g} | {one['steps']:.3g} "
              f"| {one['volume']:.5f} | {one['worst']:.5f} | {ratio} | {kept} |")
