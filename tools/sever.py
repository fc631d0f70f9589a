"""Three sites far apart carry out one application together, while lines are cut and runtimes killed at random.

    PYTHONPATH=tests python tools/sever.py --seed 7 --blows 40

Each site is a network namespace in which `onika site serve` runs, as guide 38 sets it up; who launches the runtimes and
joins them is in a namespace of its own, so lines to him are cut as well. Every flow has a tag before each step. What
each flow did is written down by its own module, with the machine's clock, and judged afterwards: nobody was driven on
alone for longer than the stated bound, nobody passed a tag alone, every step was done, a Stop reached everybody to whom
a way was open. It needs root, and ends with 1 where a promise was broken.
"""

import argparse
import os
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path

from far_line import FarLine
from severing.campaign import HOME, SITES, Campaign
from severing.far_site import LIST

KINDS = "cut,cut,one way,one way,alone,freeze,kill,stop"


def campaign(folder: Path, token: str, given: argparse.Namespace, hosts: Sequence[str]) -> int:
    """From within the namespace of whoever joins them."""
    blows, kinds = given.blows, given.kinds.split(",")
    running = Campaign(folder, token, hosts, given.seed)
    running.is_loud = True
    for _ in range(blows):
        running.strike(running.random.choice(kinds))
        print(
            f"    {running.lone} alone, {running.longest_ns / 1e6:.0f} of {running.alone_ns / 1e6:.0f} ms", flush=True
        )
    for site in running.sites:
        site.leave()
    skew = sorted(running.skews_us) or [0.0]
    middle, last = skew[len(skew) // 2], skew[int(0.99 * (len(skew) - 1))]
    print(f"{blows} blows {running.kinds}: {running.lone} begun alone, the longest {running.longest_ns / 1e6:.0f} ms, "
          f"stated {running.alone_ns / 1e6:.0f} ms; {len(skew)} begun together, apart p50 {middle / 1e3:.2f}, "
          f"p99 {last / 1e3:.2f}, most {skew[-1] / 1e3:.2f} ms; {len(running.faults)} promises broken")  # fmt: skip
    return int(bool(running.faults))


def serve(line: FarLine, folder: Path, token: str, given: argparse.Namespace) -> int:
    """Begin the services of the sites and the campaign, and cut lines as it says."""
    hosts = [line.address(site) for site in range(SITES)]
    onika = str(Path(sys.executable).with_name("onika"))
    services = []
    for site, host in enumerate(hosts):
        words = [onika, "site", "serve", str(folder / "list"), "--name", f"site{site}", "--listen", f"{host}:7995"]
        words += ["--users", str(folder / "users"), "--cert", f"{folder}/tls.crt", "--key", f"{folder}/tls.key"]
        state = os.environ | {"XDG_STATE_HOME": str(folder / f"state{site}")}
        with (folder / f"site{site}.log").open("wb") as log:
            service = subprocess.Popen(
                line.within(site, [*words, "--no-black-box"]), env=state, stdout=subprocess.PIPE, stderr=log
            )
        assert service.stdout is not None
        if not service.stdout.readline():
            raise SystemExit((folder / f"site{site}.log").read_text())
        services.append(service)
    words = [sys.executable, __file__, "--within", str(folder), token, *hosts]
    words += ["--seed", str(given.seed), "--blows", str(given.blows), "--kinds", given.kinds]
    campaigning = subprocess.Popen(line.within(HOME, words), stdout=subprocess.PIPE, text=True)
    assert campaigning.stdout is not None
    for said in campaigning.stdout:
        match said.split():
            case ["@cut", one, other, both]:
                line.cut(int(one), int(other), both=both == "1")
            case ["@mend"]:
                line.mend()
            case _:
                print(said, end="", flush=True)
    code = campaigning.wait()
    for site, service in enumerate(services):
        service.terminate()
        service.wait(30)
        print((folder / f"site{site}.log").read_text(), end="")
    return code


def main() -> int:
    """The program."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--blows", type=int, default=24)
    parser.add_argument("--kinds", default=KINDS, help="of blows, by commas; twice is twice as often")
    parser.add_argument("--delay-ms", type=float, default=100.0, help="one way")
    parser.add_argument("--loss", type=float, default=0.02)
    parser.add_argument("--within", nargs="+", help=argparse.SUPPRESS)
    given = parser.parse_args()
    if given.within:
        folder, token, *hosts = given.within
        return campaign(Path(folder), token, given, hosts)
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        words = [sys.executable, "-m", "onika.host.sessions.users", "owner", "owner", str(folder / "users")]
        token = subprocess.run(words, check=True, capture_output=True, text=True).stdout.strip()
        (folder / "list").write_text(LIST)
        names = ",".join(f"IP:10.9.0.{site + 1}" for site in range(SITES))
        asked = ["openssl", "req", "-x509", "-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:prime256v1", "-nodes"]
        asked += ["-keyout", f"{name}/tls.key", "-out", f"{name}/tls.crt", "-subj", "/CN=far"]
        subprocess.run([*asked, "-addext", f"subjectAltName={names}"], check=True, capture_output=True)
        (folder / "tls.key").chmod(0o600)
        delay_s = given.delay_ms / 1e3
        with FarLine(SITES + 1, delay_s, jitter_s=delay_s / 10, loss=given.loss, seed=given.seed) as line:
            return serve(line, folder, token, given)


if __name__ == "__main__":
    sys.exit(main())
