"""targets_table.py OUT NAME...: prints the table of bench/search/targets from its results."""
import json
import statistics
import sys

out, names = sys.argv[1], sys.argv[2:]
print("| study | search | runs at 5, 10 (and 15) mm | particle-steps, median | hypervolume, median | worst | fewer steps | hypervolume kept |")
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
            "runs": [statistics.median(runs) for runs in zip(*(row["runs"] for row in rows))],
        }
    for search, one in found.items():
        ratio = kept = ""
        if search == "new":
            ratio = f"{found['old']['steps'] / one['steps']:.1f} times (asked: 3)"
            kept = f"{100 * one['volume'] / found['old']['volume']:.1f} % (asked: 98)"
        print(f"| `{name}` | {search} | {', '.join(f'{count:g}' for count in one['runs'])} | {one['steps']:.3g} "
              f"| {one['volume']:.5f} | {one['worst']:.5f} | {ratio} | {kept} |")
