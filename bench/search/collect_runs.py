"""collect_runs.py STUDY.json OUT.jsonl FILE...: a line for each run that bench/search/targets needs.

FILE: what `parapet evaluate` printed, or the log of a study (evaluations.jsonl, confirmations.jsonl)
with the same case and variables. Runs of a spacing that cannot tell the launch are left out.
"""
import json
import sys

METRICS = ("retention_efficiency", "retention_efficiency_total", "launch_length_m")


def rows_of(files, variables):
    seen = set()
    for name in files:
        with open(name, encoding="utf-8") as file:
            for line in file:
                run = json.loads(line)
                if run["status"] != "ok" or "launch_length_m" in (run.get("metrics_unknown") or {}):
                    continue
                design = {variable: run["design"][variable] for variable in variables}
                key = json.dumps([run["spacing_m"], design])
                if key in seen:
                    continue
                seen.add(key)
                yield {"design": design, "spacing_m": run["spacing_m"],
                       "particle_steps": run["particle_steps"],
                       "metrics": {metric: run["metrics"].get(metric) for metric in METRICS}}


def main(study, out, *files):
    with open(study, encoding="utf-8") as file:
        variables = list(json.load(file)["variables"])
    with open(out, "w", encoding="utf-8") as file:
        for row in rows_of(files, variables):
            file.write(json.dumps(row) + "\n")


main(*sys.argv[1:])
