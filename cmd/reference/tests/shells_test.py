#!/usr/bin/env python3
"""Holds the manual pages and the completions against what `wm3d COMMAND --help` says: shells_test.py PAGES WM3D

Every option of every command has to be on the command's manual page and among what each shell offers. bash and fish are
asked, zsh is typed to; a shell that is not installed is left out with a word.
"""
import os
import pathlib
import pty
import re
import select
import shutil
import subprocess
import sys
import tempfile
import time

pages, wm3d = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
failures = []


def check(condition, message):
    if not condition:
        failures.append(message)


def output_of(*command, **keywords):
    return subprocess.run(command, check=True, capture_output=True, text=True, **keywords).stdout


def help_of(command):
    """The long and short options that the help lists."""
    options = set()
    for line in output_of(wm3d, command, "--help").splitlines():
        if match := re.match(r"  ((?:-\w,)?--[\w-]+|-\w)\b", line):
            options.update(match[1].split(","))
    return options


def rendered(page, width):
    environment = dict(os.environ, MANWIDTH=str(width), LC_ALL="C.UTF-8", MAN_KEEP_FORMATTING="")
    text = output_of("man", "-l", str(page), env=environment)
    return re.sub(r".\x08", "", text)


def check_manual(options):
    for command, expected in options.items():
        page = pages / f"wm3d-{command}.1"
        raw = page.read_text().replace("\\-", "-")
        for option in expected:
            check(f"\\fB{option}\\fR" in raw, f"{page.name} lacks {option}")
        if shutil.which("man"):
            for width in (40, 100):
                text = rendered(page, width)
                for option in expected:
                    check(re.search(rf"(?<![\w-]){option}(?![\w-])", text), f"{page.name} at width {width} lacks {option}")
    overview = (pages / "wm3d.1").read_text().replace("\\-", "-")
    for command in options:
        check(f"\\fBwm3d-{command}\\fR(1)" in overview, f"wm3d.1 lacks {command}")


def bash(*words):
    script = ('source "$1"; shift; COMP_WORDS=(wm3d "$@"); COMP_CWORD=$#; _wm3d; printf "%s\\n" "${COMPREPLY[@]}"')
    return output_of("bash", "-c", script, "bash", pages / "wm3d.bash", *words, cwd=folder).split()


def fish(line):
    out = output_of("fish", "--no-config", "-c", f"source {pages}/wm3d.fish; complete -C '{line}'", cwd=folder)
    return [row.split("\t")[0] for row in out.splitlines()]


def check_bash(options):
    check(set(options) <= set(bash("")), f"bash offers not every command: {bash('')}")
    check(bash("ver") == ["verify"], f"bash makes {bash('ver')} of 'ver'")
    for command, expected in options.items():
        offered = set(bash(command, "-"))
        check(offered == expected, f"bash offers {offered ^ expected} for {command} too much or not at all")
    check(bash("mark", "--normals", "") == ["keep", "recompute"], "bash: values after a space")
    check(bash("mark", "--normals", "=", "re") == ["recompute"], "bash: values after =")
    check(bash("mark", "--strength", "") == [], "bash offers something for a number")
    check(bash("mark", "model.ply", "--key", "own") == ["owner.key"], "bash: files for an option")
    check("model.ply" in bash("mark", ""), "bash: files for an argument")


def check_fish(options):
    for command, expected in options.items():
        offered = set(fish(f"wm3d {command} -")) | set(fish(f"wm3d {command} --"))
        check(expected <= offered, f"fish doesn't offer {expected - offered} for {command}")
    check(set(fish("wm3d mark --normals ")) == {"keep", "recompute"}, "fish: values")
    check("model.ply" in fish("wm3d mark m"), "fish: files")
    check("verify" in fish("wm3d ver"), "fish: commands")


def zsh_makes(expected, line):
    """Whether zsh shows some text, which is not in the line itself, after a line and the Tab key; it has a minute for it."""
    process, terminal = pty.fork()
    if process == 0:
        os.chdir(folder)
        os.execvpe("zsh", ["zsh", "-f", "-i"], dict(os.environ, TERM="dumb", PS1="$ "))
    setup = (f"fpath=({pages} $fpath); autoload -U compinit; compinit -u -D; unsetopt zle_bracketed_paste; "
             "setopt list_rows_first; LISTMAX=0; echo rea''dy\n")
    text, deadline, sent = "", time.monotonic() + 60, False
    os.write(terminal, setup.encode())
    while time.monotonic() < deadline and not (sent and expected in text):
        if select.select([terminal], [], [], 1)[0]:
            text += os.read(terminal, 65536).decode(errors="replace").replace("\a", "")
        if not sent and "ready" in text:
            text, sent = "", True
            os.write(terminal, (line + "\t").encode())
    os.write(terminal, b"\x03exit\n")
    os.close(terminal)
    os.waitpid(process, 0)
    return sent and expected in text


def check_zsh(options):
    output_of("zsh", "-n", pages / "_wm3d")
    script = (pages / "_wm3d").read_text()
    for command, expected in options.items():
        section = script[script.index(f"\n        {command}) _arguments"):].split(";;")[0]
        for option in expected:
            check(re.search(rf"[\s,{{']{option}[,}}'\[]", section), f"zsh has no {option} for {command}")
    check(zsh_makes("--normals", "wm3d mark --norm"), "zsh doesn't complete --norm")
    check(zsh_makes("verify", "wm3d ver"), "zsh doesn't complete ver")
    check(zsh_makes("recompute", "wm3d mark --normals re"), "zsh doesn't complete a value")
    check(zsh_makes("owner.key", "wm3d mark --key ow"), "zsh doesn't complete a file")


names = re.findall(r"^  ([a-z]+)  ", output_of(wm3d, "--help"), re.MULTILINE)
assert "mark" in names and "verify" in names, names
all_options = {name: help_of(name) for name in names}
with tempfile.TemporaryDirectory() as folder:
    for name in ("model.ply", "owner.key"):
        pathlib.Path(folder, name).touch()
    check_manual(all_options)
    for shell, test in (("bash", check_bash), ("fish", check_fish), ("zsh", check_zsh)):
        if shutil.which(shell):
            test(all_options)
        else:
            print(f"{shell} is not installed; its completion is not tried")
print("\n".join(failures) or f"{sum(map(len, all_options.values()))} options of {len(names)} commands are everywhere")
sys.exit(bool(failures))
