#!/usr/bin/env python3
"""The executable when things go wrong around it: full disks, signals, kills at any moment, odd places, secrets.

faults.py WM3D TestClass [KILLS]; `scripts/faults` runs the long form. Counts go to standard output as "counted: ..."."""
import json
import os
import pathlib
import pty
import random
import re
import resource
import shutil
import signal
import subprocess
import sys
import time
import unittest

import outside
from outside import InFolder, wm3d

KILLS = 12  # the quick form; the long one has 300


def counted(text):
    print(f"counted: {text}", flush=True)


def contents(folder):
    return {str(path.relative_to(folder)): path.read_bytes() for path in sorted(folder.rglob("*")) if path.is_file()}


class Faults(InFolder):
    """No room, or no leave, to write: a sentence, and every file as it was."""

    def setUp(self):
        super().setUp()
        self.source, self.owner = self.sample(4000), self.key()
        self.target, self.receipt = self.folder / "marked.ply", self.folder / "receipt"
        self.command = ["mark", self.source, "-o", self.target, "--key", self.owner, "--strength", "0.3",
                        "--receipt", self.receipt, "--commitment", self.folder / "c"]

    def check_refused(self, done, before, folder=None):
        self.assertEqual(done.returncode, 2, done.stderr)
        message = done.stderr.decode()
        self.assertEqual(message.count("\n"), 1, message)
        self.assertIn("error: ", message)
        self.assertEqual(contents(folder or self.folder), before)

    def test_every_limit_of_a_file_size(self):
        """The disk is full after n bytes, for n from nothing to nearly all that is needed."""
        self.assertEqual(wm3d(*self.command).returncode, 0)
        sizes = [path.stat().st_size for path in (self.target, self.receipt)]
        for path in (self.target, self.receipt):
            path.write_bytes(b"old " + path.name.encode())
        before = contents(self.folder)
        for limit in sorted({0, 1, 60, 400, 4096, min(sizes) - 1, max(sizes) - 1}):
            def small():
                signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
                resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))
            self.check_refused(wm3d(*self.command, "--overwrite", preexec_fn=small), before)
        counted(f"{7} sizes at which writing stops, nothing changed")

    def test_small_full_file_system(self):
        mount = self.folder / "small"
        mount.mkdir()
        if subprocess.run(["mount", "-t", "tmpfs", "-o", "size=256k", "none", mount], capture_output=True).returncode:
            self.skipTest("SKIPPED: mounting a small file system is not allowed here")
        try:
            self.target, self.receipt = mount / "marked.ply", mount / "receipt"
            command = ["mark", self.source, "-o", self.target, "--key", self.owner, "--strength", "0.3", "--receipt",
                       self.receipt, "--overwrite"]
            self.assertEqual(wm3d(*command).returncode, 0)
            whole = contents(mount)
            room = 256 * 1024 - sum(len(data) for data in whole.values())
            filler = mount / "filler"
            for left in (0, 4096, 16384, 65536):
                filler.write_bytes(b"x" * max(0, room - 16384 - left))
                try:
                    with filler.open("ab") as file:  # what the rounding to pages leaves
                        while left == 0:
                            file.write(b"x" * 4096)
                            file.flush()
                except OSError:
                    pass
                before = contents(mount)
                done = wm3d(*command, "--pf", "1e-9")
                if done.returncode == 0:  # there was room for all of it
                    self.assertTrue(self.target.read_bytes().startswith(b"ply"))
                else:
                    self.check_refused(done, before, mount)
            self.assertFalse(list(mount.glob(".wm3d*")))
        finally:
            subprocess.run(["umount", mount], check=True)
        counted("4 degrees of a full file system of 256 KiB, nothing lost")

    def test_full_devices_and_closed_streams(self):
        with open("/dev/full", "wb") as full:
            for command in (["sample", "-o", "-", "--format", "ply", "--faces", "2000"], ["info", self.source],
                            ["verify", self.source, "--key", self.owner, "--json"], ["--version"], ["info", "--help"]):
                done = subprocess.run([outside.WM3D, *map(str, command)], stdout=full, stderr=subprocess.PIPE)
                self.assertEqual(done.returncode, 2, command)
                self.assertEqual(done.stderr.count(b"\n"), 1, done.stderr)
        for device in ("/dev/null", "/dev/full"):
            mode = os.stat(device).st_rdev
            done = wm3d("mark", self.source, "-o", device, "--format", "ply", "--key", self.owner, "--overwrite")
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertEqual(os.stat(device).st_rdev, mode)  # still the device

    def test_the_key_is_never_written_over(self):
        before = contents(self.folder)
        for option in ("--receipt", "--commitment"):
            done = wm3d("mark", self.source, "-o", self.target, "--key", self.owner, option, self.owner, "--overwrite")
            self.check_refused(done, before)
        self.check_refused(wm3d("mark", self.source, "-o", self.target, "--key", self.owner, "--strength", "0.3", "--receipt",
                                self.target), before)

    def test_a_folder_that_can_only_be_read(self):
        locked = self.folder / "locked"
        locked.mkdir()
        shutil.copy(self.source, locked / "in.ply")
        locked.chmod(0o555)
        try:
            if os.access(locked, os.W_OK):  # root may write anywhere; a read-only mount stops root too
                if subprocess.run(["mount", "--bind", locked, locked], capture_output=True).returncode or \
                        subprocess.run(["mount", "-o", "remount,ro,bind", locked], capture_output=True).returncode:
                    self.skipTest("SKIPPED: this user may write anywhere")
            before = contents(self.folder)
            done = wm3d("mark", locked / "in.ply", "-o", locked / "out.ply", "--key", self.owner, "--strength", "0.3")
            self.check_refused(done, before)
            self.assertIn(wm3d("verify", locked / "in.ply", "--key", self.owner).returncode, (1, 3))
        finally:
            subprocess.run(["umount", locked], capture_output=True)
            locked.chmod(0o755)

    def test_logs_of_others_are_left_alone(self):
        for text in ('{"asset":{"version":"2.0"}}', "no line end", "[1]\n[2]\n", '{"schema":"wm3d.verify/1"'):
            log = self.folder / "log"
            log.write_text(text)
            done = wm3d("analyze", self.source, "--trials", "1", "--strength", "0.3", "--resume", log)
            self.assertEqual(done.returncode, 2)
            self.assertEqual(log.read_text(), text)


class Kills(InFolder):
    """SIGKILL, and the signals that ask, at random moments: files are old or new, whole, and go together."""

    def setUp(self):
        super().setUp()
        self.random = random.Random(8)
        self.source, self.owner = self.sample(4000, "gltf"), self.key()
        # Buffers beside the model: three files have to go together.
        asset = json.loads(self.source.read_text())
        uri = asset["buffers"][0]["uri"]
        import base64
        (self.folder / "sample.bin").write_bytes(base64.b64decode(uri.split(",", 1)[1]))
        asset["buffers"][0]["uri"] = "sample.bin"
        self.source.write_text(json.dumps(asset))

    def run_and_kill(self, command, seconds, how):
        process = subprocess.Popen([outside.WM3D, *map(str, command)], stdout=subprocess.DEVNULL,
                                   stderr=subprocess.DEVNULL)
        time.sleep(seconds * self.random.random())
        process.send_signal(how)
        process.wait()
        return process.returncode

    def test_mark(self):
        work = self.folder / "work"
        work.mkdir()
        base = ["mark", self.source, "-o", work / "m.gltf", "--key", self.owner, "--receipt", work / "r", "--overwrite"]
        states = []
        started = time.monotonic()
        for strength in ("0.3", "0.35"):
            self.assertEqual(wm3d(*base, "--strength", strength).returncode, 0)
            states.append(contents(work))
        seconds = (time.monotonic() - started) / 2 * 1.1
        inputs = {name: data for name, data in contents(self.folder).items() if not name.startswith("work/")}
        old, new = states
        self.assertEqual(sorted(old), ["m.bin", "m.gltf", "r"])
        died = amid = 0
        rounds = max(3, KILLS * 2 // 3)
        for round_ in range(rounds):
            for path in work.iterdir():
                path.unlink()
            for name, data in old.items():
                (work / name).write_bytes(data)
            how = signal.SIGKILL if round_ % 4 else self.random.choice((signal.SIGTERM, signal.SIGINT, signal.SIGHUP))
            died += self.run_and_kill([*base, "--strength", "0.35"], seconds, how) < 0
            found = contents(work)
            left = [data for name, data in found.items() if name not in old]
            amid += bool(left)  # while names were being taken, of which only a kill leaves a trace
            for name in old:
                self.assertIn(found[name], (old[name], new[name]), f"{name} is neither old nor new")
            for data in left:
                self.assertIn(data, [*old.values(), *new.values()], "a temporary file is not whole")
            # In the order in which they take their names, new ones come before old ones.
            fresh = [name for name in ("m.bin", "m.gltf", "r") if found[name] == new[name]]
            self.assertIn(fresh, ([], ["m.bin"], ["m.bin", "m.gltf"], ["m.bin", "m.gltf", "r"]))
            if 0 < len(fresh) < 3:
                for name in fresh:
                    self.assertIn(old[name], left, "a mixed set, and what was replaced is gone")
            outside_ = {name: data for name, data in contents(self.folder).items() if not name.startswith("work/")}
            self.assertEqual(outside_, inputs)
        counted(f"mark: {rounds} kills, {died} in time, {amid} of them while names were taken, no file lost; "
                "all others without a mixed set or a temporary file")

    def test_resume(self):
        log, seconds = self.folder / "trials", None
        command = ["analyze", self.source, "--trials", "6", "--strength", "0.3", "--pf", "1e-6", "--json"]
        started = time.monotonic()
        expected = wm3d(*command)
        self.assertEqual(expected.returncode, 0, expected.stderr)
        seconds = time.monotonic() - started
        kills = died = 0
        while kills < max(3, KILLS // 6):
            kills += 1
            died += self.run_and_kill([*command, "--resume", log], seconds, signal.SIGKILL) < 0
            if log.exists():
                for line in log.read_text().split("\n")[:-1]:
                    json.loads(line)  # whole lines
            if kills % 5 == 0:
                self.assertEqual(wm3d(*command, "--resume", log).stdout, expected.stdout)
                log.unlink()
        self.assertEqual(wm3d(*command, "--resume", log).stdout, expected.stdout)
        counted(f"analyze --resume: {kills} kills, {died} in time, same figures as without")

    def test_bench(self):
        out, model = self.folder / "results", self.folder / "model.ply"
        self.assertEqual(wm3d("sample", "-q", "-o", model, "--faces", "4000").returncode, 0)
        command = ["bench", "--models", model, "--out", out, "--strengths", "0.3", "--keys", "2", "--attacks",
                   "quantization:10,noise:0.1"]
        started = time.monotonic()
        first = wm3d(*command)
        if first.returncode == 2 and b"not a command" in first.stderr:
            self.skipTest("SKIPPED: this build has no bench")
        self.assertEqual(first.returncode, 0, first.stderr)
        seconds = time.monotonic() - started
        table = (out / "summary.csv").read_bytes() if (out / "summary.csv").exists() else None
        shutil.rmtree(out)
        kills = died = 0
        while kills < max(3, KILLS // 6):
            kills += 1
            died += self.run_and_kill(command, seconds, signal.SIGKILL) < 0
            if kills % 3 == 0:  # enough of them have left nothing to do
                self.assertEqual(wm3d(*command).returncode, 0)
                if table is not None:
                    self.assertEqual((out / "summary.csv").read_bytes(), table)
                self.assertFalse(list(out.rglob(".wm3d*")))
                shutil.rmtree(out)
        counted(f"bench: {kills} kills, {died} in time, same table as without")


class Anywhere(InFolder):
    """Languages, clocks, names and numbers of threads change nothing."""

    def test_locales_and_time_zones(self):
        source, owner = self.sample(4000), self.key()
        outputs = set()
        known = subprocess.run(["locale", "-a"], capture_output=True, text=True).stdout.split()
        names = {"C", "POSIX", "C.UTF-8", "nonsense", *(name for name in known if re.match("de|fr|tr|ja", name))}
        for number, name in enumerate(sorted(names)):
            environment = {**os.environ, "LC_ALL": name, "LANG": name, "TZ": ("UTC", "Asia/Kathmandu", "nonsense")[number % 3]}
            target = self.folder / f"{number}.ply"
            done = wm3d("mark", source, "-o", target, "--key", owner, "--strength", "0.3", "--json",
                        "--threads", str(1 + number % 3), env=environment)
            self.assertEqual(done.returncode, 0, done.stderr)
            outputs.add((target.read_bytes(), done.stdout.replace(str(target).encode(), b"")))
        self.assertEqual(len(outputs), 1)
        counted(f"{len(names)} locales with 3 time zones and 1 to 3 threads, the same bytes")

    def test_names_of_every_kind(self):
        source, owner = self.sample(4000), self.key()
        names = ["with space", "Büste 名前", "-dash", "--overwrite", "new\nline", "a'b\"c$(x)`;&|", "%s%n", "x" * 200, "*"]
        for name in names:
            folder = self.folder / "in" / name
            folder.mkdir(parents=True)
            shutil.copy(source, folder / f"{name}.ply")
            done = wm3d("mark", "--strength", "0.3", "--key", owner, "-o", "./out.ply", "--receipt", "./r", "--",
                        f"{name}.ply", cwd=folder)
            self.assertEqual(done.returncode, 0, (name, done.stderr))
            self.assertEqual(sorted(path.name for path in folder.iterdir()), sorted([f"{name}.ply", "out.ply", "r"]))
            missing = wm3d("info", "--", f"{name}-.ply", cwd=folder)
            self.assertEqual(missing.returncode, 2)
            self.assertEqual(missing.stderr.count(b"\n"), 1, missing.stderr)
            if name.startswith("-"):
                mistaken = wm3d("info", f"{name}.ply", cwd=folder)
                self.assertEqual(mistaken.returncode, 2)
                self.assertIn(f"the file of that name is './{name}.ply'".encode(), mistaken.stderr)
        counted(f"{len(names)} odd names of files and folders")


class Absurd(InFolder):
    """Sizes that are only declared, numbers of any magnitude, maps far from their origin."""

    def test_declared_sizes(self):
        count = 4294967295
        ply = ("ply\nformat binary_little_endian 1.0\nelement vertex {0}\nproperty float x\nproperty float y\nproperty float z\n"
               "element face {0}\nproperty list uchar int vertex_indices\nend_header\n").format(count).encode()
        files = {"big.ply": ply + bytes(40), "big.off": f"OFF\n{count} {count} 0\n0 0 0\n".encode(),
                 "big.stl": bytes(80) + b"\xff" * 4 + bytes(50),
                 "cycle.gltf": b'{"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],'
                               b'"nodes":[{"children":[1]},{"children":[0]}],"meshes":[]}'}

        def little_memory():
            resource.setrlimit(resource.RLIMIT_AS, (1 << 30, 1 << 30))
        for name, data in files.items():
            (self.folder / name).write_bytes(data)
            done = wm3d("info", self.folder / name, "--threads", "1", preexec_fn=little_memory, timeout=20)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertEqual(done.stderr.count(b"\n"), 1, done.stderr)
            self.assertNotIn(b"memory", done.stderr)
        counted(f"{len(files)} files of at most 300 bytes that declare or nest without end, refused within 1 GiB")

    def scaled(self, name, change):
        path = self.folder / f"{name}.obj"
        with path.open("w") as out:
            for line in self.source.open():
                if line.startswith("v "):
                    line = "v {!r} {!r} {!r}\n".format(*(change(float(word)) for word in line.split()[1:4]))
                out.write(line)
        return path

    def test_numbers_of_any_magnitude(self):
        self.source, owner = self.sample(20000, "obj"), self.key()
        found = {}
        for name, change in {"1e-30": lambda x: x * 1e-30, "1": lambda x: x, "1e30": lambda x: x * 1e30,
                             "6,000 km away": lambda x: x * 0.3 + 6e6}.items():
            model, marked = self.scaled(name.split()[0], change), self.folder / "marked.obj"
            done = wm3d("mark", model, "-o", marked, "--key", owner, "--strength", "0.1", "--overwrite")
            self.assertEqual(done.returncode, 0, (name, done.stderr))
            done = wm3d("verify", marked, "--key", owner, "--effort", "0", "--json")
            self.assertEqual(done.returncode, 0, (name, done.stderr))
            found[name] = json.loads(done.stdout)["log10_p"]
        for name, log10_p in found.items():
            self.assertLess(abs(log10_p - found["1"]), 0.1 * abs(found["1"]), found)
        for factor in (1e-300, 1e-150, 1e150, 1e300):
            done = wm3d("mark", self.scaled("beyond", lambda x: x * factor), "-o", self.folder / "x.obj", "--key", owner)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertEqual(done.stderr.count(b"\n"), 1, done.stderr)
            self.assertIn(b"scale the model", done.stderr)
        counted(f"log10 p by magnitude: {found}; 4 magnitudes beyond 1e150 refused")


class Commitments(InFolder):
    def test_a_commitment_is_dated_and_checked_with_other_tools(self):
        source, owner = self.sample(4000), self.folder / "owner.key"
        self.assertEqual(wm3d("keygen", owner, "--commitment", self.folder / "key.c").returncode, 0)
        marked, receipt, commitment = (self.folder / name for name in ("marked.ply", "receipt", "mark.c"))
        done = wm3d("mark", source, "-o", marked, "--key", owner, "--strength", "0.3", "--receipt", receipt,
                    "--commitment", commitment, "--json")
        self.assertEqual(json.loads(done.stdout)["commitment"], str(commitment), done.stderr)
        for name in ("key.c", "mark.c"):
            checked = subprocess.run(["sha256sum", "--check", f"{name}.sha256"], cwd=self.folder, capture_output=True)
            self.assertEqual(checked.returncode, 0, checked.stderr)
            if shutil.which("openssl"):
                query = subprocess.run(["openssl", "ts", "-query", "-in", self.folder / f"{name}.tsq", "-text"],
                                       capture_output=True, text=True)
                self.assertEqual(query.returncode, 0, query.stderr)
                digest = (self.folder / f"{name}.sha256").read_text().split()[0]
                shown = "".join(re.findall(r"^ +[0-9a-f]{4} - ([0-9a-f -]+?)   ", query.stdout, re.M))
                self.assertEqual(re.sub("[ -]", "", shown), digest)
                self.assertIn("Hash Algorithm: sha256", query.stdout)

        def condition(*more):
            done = wm3d("verify", marked, "--key", owner, "--json", *more)
            self.assertIn(done.returncode, (0, 3), done.stderr)
            return json.loads(done.stdout)["condition"]
        self.assertNotIn("commitment", condition())
        self.assertEqual([condition("--commitment", self.folder / "key.c")["commitment"][what]
                          for what in ("fixes_key", "fixes_settings")], [True, True])
        used = condition("--commitment", commitment, "--receipt", receipt)
        self.assertTrue(used["commitment"]["fixes_receipt"])
        self.assertIn("receipt", used["holds_if"])
        self.assertFalse(condition("--commitment", self.folder / "key.c", "--receipt", receipt)
                         ["commitment"]["fixes_receipt"])
        self.assertFalse(condition("--commitment", commitment, "--vertices", "3000")["commitment"]["fixes_settings"])

        other = self.key("other")
        for arguments in ([other, "--commitment", commitment], [owner, "--commitment", receipt],
                          [owner, "--commitment", source]):
            done = wm3d("verify", marked, "--key", *arguments)
            self.assertEqual(done.returncode, 2)
            self.assertEqual(done.stderr.count(b"\n"), 1, done.stderr)
        another = self.folder / "another"  # of the same key and model, but of another mark
        wm3d("mark", source, "-o", self.folder / "again.ply", "--key", owner, "--strength", "0.31", "--receipt", another)
        done = wm3d("verify", marked, "--key", owner, "--commitment", commitment, "--receipt", another)
        self.assertEqual(done.returncode, 2)
        self.assertIn(b"not the one that was committed to", done.stderr)

    def test_text_says_the_condition_beside_the_verdict(self):
        source, owner = self.sample(4000), self.key()
        self.assertIn(b"it holds if the key and the settings were fixed before the suspect was seen",
                      wm3d("verify", source, "--key", owner).stdout)


def with_passphrase(text, *command, **options):
    read, write = os.pipe()
    os.write(write, text.encode())
    os.close(write)
    try:
        return wm3d(*command, "--passphrase-fd", read, pass_fds=(read,), **options)
    finally:
        os.close(read)


class Passphrases(InFolder):
    def protected(self, text="open sesame\n"):
        path = self.folder / "protected.key"
        self.assertEqual(with_passphrase(text, "keygen", path).returncode, 0)
        return path

    def test_a_protected_key_needs_its_passphrase(self):
        source, path = self.sample(4000), self.protected()
        text = path.read_text()
        self.assertIn("protected-secret: argon2id 3 256 ", text)
        self.assertNotIn("sesame", text)
        marked = self.folder / "marked.ply"
        for answer, status in (("open sesame", 0), ("open sesame\r\nmore", 0), ("open sesam", 2), ("", 2), ("\n", 2)):
            done = with_passphrase(answer, "mark", source, "-o", marked, "--key", path, "--strength", "0.3", "--overwrite",
                                   "--json")
            self.assertEqual(done.returncode, status, (answer, done.stderr))
            self.assertNotIn(b"sesam", done.stdout + done.stderr)
        self.assertEqual(with_passphrase("open sesame", "verify", marked, "--key", path).returncode, 0)
        done = wm3d("verify", marked, "--key", path, start_new_session=True)  # nobody to ask
        self.assertEqual(done.returncode, 2)
        self.assertIn(b"--passphrase-fd", done.stderr)
        self.assertEqual(wm3d("verify", marked, "--key", path, "--passphrase-fd", "77").returncode, 2)

    def on_terminal(self, answers, *command):
        """Runs a command on a terminal of its own, answers its questions. (status, all that the terminal showed)"""
        process, ours = pty.fork()
        if process == 0:
            os.execv(outside.WM3D, [outside.WM3D, *map(str, command)])
        shown, answers = b"", list(answers)
        while True:
            try:
                block = os.read(ours, 4096)
            except OSError:
                break
            shown += block
            if answers and shown.rstrip().endswith(b":"):
                time.sleep(0.2)
                os.write(ours, answers.pop(0))
        os.close(ours)
        return os.waitstatus_to_exitcode(os.waitpid(process, 0)[1]), shown

    def test_the_terminal_asks_and_does_not_show(self):
        source, path = self.sample(4000), self.folder / "k"
        status, shown = self.on_terminal([b"hush hush\n", b"hush hush\n"], "keygen", path, "--passphrase")
        self.assertEqual(status, 0, shown)
        self.assertNotIn(b"hush", shown)
        status, shown = self.on_terminal([b"hush hush\n"], "verify", source, "--key", path)
        self.assertIn(status, (1, 3), shown)
        self.assertNotIn(b"hush", shown)
        status, shown = self.on_terminal([b"wrong\n"], "verify", source, "--key", path)
        self.assertEqual(status, 2, shown)
        status, shown = self.on_terminal([b"one\n", b"two\n"], "keygen", self.folder / "l", "--passphrase")
        self.assertEqual(status, 2, shown)
        self.assertFalse((self.folder / "l").exists())
        status, shown = self.on_terminal([b"half\x03"], "verify", source, "--key", path)
        self.assertEqual(status, -signal.SIGINT, shown)

    def test_no_core_dump_and_no_secret_in_dumpable_memory(self):
        source, owner = self.sample(60000), self.key()
        secret = re.search("^secret: (.*)$", owner.read_text(), re.M).group(1)
        process = subprocess.Popen([outside.WM3D, "verify", str(source), "--key", str(owner), "--null-keys", "100000"],
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)  # so many that it is at work
        try:
            limits = pathlib.Path(f"/proc/{process.pid}/limits")
            for _ in range(400):  # until it has read the key
                if re.search(r"Max core file size +0 +0", limits.read_text()):
                    break
                time.sleep(0.01)
            else:
                self.fail("core dumps are not forbidden")
            time.sleep(0.3)
            self.assertIsNone(process.poll(), "it ended too early to look into it")
            process.send_signal(signal.SIGSTOP)
            looked = self.look_for((secret.encode(), bytes.fromhex(secret)), process.pid)
        finally:
            process.kill()
            process.wait()
        if looked == 0:
            self.skipTest("SKIPPED: the memory of other processes can't be read here")
        counted(f"{looked >> 20} MiB of memory that a core dump would hold, no secret in it")

    def look_for(self, secrets, pid):
        """Looks through the memory that a core dump would hold. Returns how many bytes it saw."""
        looked, begin, end = 0, 0, 0
        try:
            memory = open(f"/proc/{pid}/mem", "rb", 0)
        except OSError:
            return 0
        for line in open(f"/proc/{pid}/smaps"):
            if match := re.match(r"([0-9a-f]+)-([0-9a-f]+) (r?)", line):
                begin, end = (int(match.group(i), 16) for i in (1, 2)) if match.group(3) else (0, 0)
            elif line.startswith("VmFlags:") and end > begin and " dd" not in line:
                try:
                    memory.seek(begin)
                    data = memory.read(end - begin)
                except OSError:
                    continue
                looked += len(data)
                for secret in secrets:
                    self.assertNotIn(secret, data, f"a secret lies at {line} {begin:x}")
        return looked


def main():
    global KILLS
    outside.WM3D = str(pathlib.Path(sys.argv[1]).resolve())
    if len(sys.argv) > 3:
        KILLS = int(sys.argv[3])
    suite = unittest.defaultTestLoader.loadTestsFromTestCase(globals()[sys.argv[2]])
    return 0 if unittest.TextTestRunner(verbosity=2).run(suite).wasSuccessful() else 1


if __name__ == "__main__":
    sys.exit(main())
