"""A path planner, as an outside partner of the task `planner`: goes round balls in the space of the joints.

    python docs/examples/planner.py tcp:127.0.0.1:7803 --ball 0.2,-0.9,0.1,0,0.3,0:0.4

A ball is its centre, one angle in rad for each joint, and its radius. Where the straight way from start to end meets
one, the way goes by a point beside it, within the limits of the joints, and so on for the parts. Nothing but Python is
needed.
"""

import json
import math
import os
import socketserver
import sys
from contextlib import suppress
from pathlib import Path

MARGIN = 1.3  # how far beside a ball, as a multiple of its radius
DEEPEST = 4


def path(start, end, low, high, balls, depth=0):
    """The points between start and end; raises ValueError where no way is found."""
    ball = next((one for one in balls if distance(start, end, one[0]) < one[1]), None)
    if ball is None:
        return []
    if depth == DEEPEST:
        raise ValueError("no way found round the balls")
    centre, radius = ball
    for sign in (1.0, -1.0):
        point = aside(start, end, centre, sign * MARGIN * radius)
        beside = [min(max(x, a), b) for x, a, b in zip(point, low, high, strict=True)]
        if math.dist(beside, centre) > radius:
            try:
                before = path(start, beside, low, high, balls, depth + 1)
                return [*before, beside, *path(beside, end, low, high, balls, depth + 1)]
            except ValueError:
                continue
    raise ValueError("no way found round the balls")


def nearest(start, end, centre):
    """The point of the straight way that is nearest to a centre."""
    way = [b - a for a, b in zip(start, end, strict=True)]
    length = sum(w * w for w in way)
    share = sum((c - a) * w for a, c, w in zip(start, centre, way, strict=True)) / length if length else 0.0
    return [a + min(max(share, 0.0), 1.0) * w for a, w in zip(start, way, strict=True)]


def distance(start, end, centre):
    """From the straight way to a centre."""
    return math.dist(nearest(start, end, centre), centre)


def aside(start, end, centre, by):
    """A point so far from the centre, on the side where the way passes it; across the way where it meets the centre."""
    way = [b - a for a, b in zip(start, end, strict=True)]
    out = [n - c for n, c in zip(nearest(start, end, centre), centre, strict=True)]
    if math.hypot(*out) < 1e-6:  # straight through the middle: along the joint that moves least, made square to the way
        least = min(range(len(way)), key=lambda k: abs(way[k]))
        length = sum(w * w for w in way) or 1.0
        out = [(k == least) - way[least] * w / length for k, w in enumerate(way)]
    size = math.hypot(*out) or 1.0
    return [c + by * o / size for c, o in zip(centre, out, strict=True)]


def answer(message, balls):
    """What a question is answered."""
    if message["ask"] != "path":
        return {"id": message["id"], "error": f"a path planner does not know how to {message['ask']}"}
    try:
        via = path(message["start"], message["end"], message["low"], message["high"], balls)
    except ValueError as wrong:
        return {"id": message["id"], "error": str(wrong)}
    return {"id": message["id"], "via": via}


class Handler(socketserver.StreamRequestHandler):
    """One task that has called."""

    def handle(self):
        """Until it hangs up."""
        for line in self.rfile:
            self.wfile.write(json.dumps(answer(json.loads(line), self.server.balls)).encode() + b"\n")


class Tcp(socketserver.ThreadingTCPServer):
    """Listens on a port."""

    allow_reuse_address, daemon_threads = True, True


class Unix(socketserver.ThreadingUnixStreamServer):
    """Listens on a path."""

    daemon_threads = True


def listen(address):
    """A server at `tcp:HOST:PORT` or `unix:PATH`."""
    kind, _, place = address.partition(":")
    if kind == "unix":
        Path(place).unlink(missing_ok=True)
        return Unix(place, Handler)
    host, _, port = place.rpartition(":")
    return Tcp((host, int(port)), Handler)


def ball_of(words):
    """`Q1,Q2,…:RADIUS`."""
    centre, _, radius = words.partition(":")
    return [float(one) for one in centre.split(",")], float(radius)


def main(words):
    """Listen at the address given, or where the task that started this says, or talk over standard input and output."""
    balls = [ball_of(words[k + 1]) for k, one in enumerate(words) if one == "--ball"]
    first = words[0] if words and not words[0].startswith("--") else os.environ.get("ONIKA_PARTNER", "")
    if first:
        with listen(first) as server:
            server.balls = balls
            server.serve_forever()
    for line in sys.stdin:
        print(json.dumps(answer(json.loads(line), balls)), flush=True)


if __name__ == "__main__":
    with suppress(KeyboardInterrupt):
        main(sys.argv[1:])
