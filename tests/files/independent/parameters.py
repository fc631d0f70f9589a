"""A.1, the task parameter file, read naively."""

from typing import Any

from .script import Script, blanks, name, one_of, real, svar, words

PORTS = ("INCONST", "OUTCONST", "INVAR", "OUTVAR")
KEYWORDS = ("MODULE", "DESC", "SVARALIAS", *PORTS, "TASKTYPE", "FREQ", "PERIOD", "ONIKA", "OBJECT", "LOCAL")


def read(text: str) -> dict[str, Any]:
    script = Script(text, versioned=False)
    result: dict[str, Any] = {"MODULE": name(script.take("MODULE")), "DESC": blanks(script.take("DESC"))}
    aliases: dict[str, str] = {}
    while script.next == "SVARALIAS":
        coded, equals, alias = script.take("SVARALIAS").partition("=")
        coded, alias = svar(coded.strip(" \t")), svar(alias.strip(" \t"))
        if not equals or coded in aliases:
            raise ValueError("SVARALIAS")
        aliases[coded] = alias
    result["SVARALIAS"] = aliases
    lists = {keyword: _ports(script.take(keyword)) for keyword in PORTS}
    every = {port for ports in lists.values() for port in ports}
    coded_of = {alias: coded for coded, alias in aliases.items() if coded not in every}
    for keyword, ports in lists.items():  # reading 8: an aliased name is accepted
        result[keyword] = [port if port in aliases else coded_of.get(port, port) for port in ports]
    result["TASKTYPE"] = one_of(script.take("TASKTYPE"), "periodic", "synchronous", "aperiodic")
    if result["TASKTYPE"] != "aperiodic":
        result["RATE"] = script.next, real(script.take(one_of(script.next, "FREQ", "PERIOD")))
        if result["RATE"][1] <= 0:
            raise ValueError("rate")
    if script.next == "ONIKA":
        _alone(script.take("ONIKA"))
        result["OBJECT"] = blanks(script.take("OBJECT"))
        kinds = result["OBJECT"].lower().split(" ")
        if "job" not in kinds or len(kinds) < 2:
            raise ValueError("type of job")
        while script.next == "TARGET":
            result.setdefault("TARGET", []).append(blanks(script.take("TARGET")))
            kinds = result["TARGET"][-1].lower().split(" ")
            if "object" not in kinds or len(kinds) < 2:
                raise ValueError("type of target")
    result["LOCAL"] = []
    if script.next == "LOCAL":
        _alone(script.take("LOCAL"))
        while script.left:
            key, rest = script.left.pop(0)
            result["LOCAL"].append((parameter(key), words(rest)))
    script.end()
    _check(result)
    return result


def parameter(key: str) -> str:
    """The name of a parameter of a module."""
    if key in KEYWORDS or any(c not in "_^.-" and not (c.isascii() and c.isalnum()) for c in key):
        raise ValueError(key)
    if not key[:1].isalpha() or key == "EOF":
        raise ValueError(key)
    return key


def _ports(text: str) -> list[str]:
    if text == "none":
        return []
    ports = [svar(word) for word in words(text)]
    if not ports or "NONE" in ports:
        raise ValueError("none must follow")
    return ports


def _alone(text: str) -> None:
    if text:
        raise ValueError(text)


def _check(result: dict[str, Any]) -> None:
    """Every name once; aliases of ports only; no variable written by two outputs (reading 9)."""
    ports = [port for keyword in PORTS for port in set(result[keyword])]
    if len(ports) != sum(len(result[keyword]) for keyword in PORTS):
        raise ValueError("a port twice")
    if not set(result["SVARALIAS"]) <= set(ports):
        raise ValueError("an alias of nothing")
    outputs = set(result["OUTCONST"]) | set(result["OUTVAR"])
    if len({result["SVARALIAS"].get(port, port) for port in outputs}) < len(outputs):
        raise ValueError("two outputs, one variable")
