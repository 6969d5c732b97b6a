"""Runs the containers of a job's manifest on this machine, one index after the other.

    containers.py MANIFEST FOLDER [NAME=VALUE]...

FOLDER stands for the working directory of the containers; the values replace those of the manifest.
"""

import os
import re
import subprocess
import sys

import yaml


def expand(text, variables):
    """What Kubernetes makes of $(NAME) and $$ in commands and arguments; what it does not know stays."""
    def value(match):
        return "$" if match[0] == "$$" else variables.get(match[1], match[0])

    return re.sub(r"\$\$|\$\(([^)]*)\)", value, text)


def main(manifest, folder, *replaced):
    with open(manifest, encoding="utf-8") as file:
        spec = yaml.safe_load(file)["spec"]
    container, = spec["template"]["spec"]["containers"]
    assert container["workingDir"] in [mount["mountPath"] for mount in container["volumeMounts"]], manifest
    variables = {variable["name"]: variable["value"] for variable in container.get("env", [])}
    if "PARTS" in variables:
        assert variables["PARTS"] == str(spec["completions"]), "PARTS is not the number of completions"
    variables.update(pair.split("=", 1) for pair in replaced)
    for index in range(spec.get("completions", 1)):
        if spec.get("completionMode") == "Indexed":
            variables["JOB_COMPLETION_INDEX"] = str(index)
        command = [expand(word, variables) for word in container["command"] + container["args"]]
        subprocess.run(command, cwd=folder, env={**os.environ, **variables}, check=True)


main(*sys.argv[1:])
