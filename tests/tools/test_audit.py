"""What the audits say becomes a verdict: advisories fail, an unreachable database is told and does not."""

import json

import audit
from audit import Outcome


def _pip(*dependencies):
    return Outcome(1, json.dumps({"dependencies": dependencies, "fixes": []}), "")


_CLEAN = {"name": "rich", "version": "15.0", "vulns": []}
_SKIPPED = {"name": "ruckig", "skip_reason": "not found"}
_SICK = {"name": "h11", "version": "0.1", "vulns": [{"id": "PYSEC-1", "fix_versions": ["0.2"]}]}
_UNREACHED = "no advisory database can be reached"


def test_an_advisory_for_a_package_of_python_fails():
    verdict = audit.judge_pip_audit(_pip(_CLEAN, _SICK))
    assert verdict.code == 1
    assert "  h11 0.1: PYSEC-1, mended in 0.2" in verdict.lines


def test_packages_without_advisories_pass_and_a_skipped_one_is_named():
    verdict = audit.judge_pip_audit(_pip(_CLEAN, _SKIPPED))
    assert verdict.code == 0
    assert verdict.lines == ("pip-audit: 1 packages looked up, 0 advisories", "pip-audit: not looked up: ruckig")


def test_an_audit_that_skipped_all_looked_nothing_up():
    verdict = audit.judge_pip_audit(_pip(_SKIPPED))
    assert (verdict.code, _UNREACHED in verdict.lines[0]) == (0, True)


def test_a_database_that_nobody_reaches_is_told_and_is_no_failure():
    verdict = audit.judge_pip_audit(Outcome(1, "", "Traceback\nrequests.exceptions.ConnectionError: no name"))
    assert (verdict.code, _UNREACHED in verdict.lines[0]) == (0, True)
    refused = json.dumps({"message": "405 Method Not Allowed", "statusCode": 405})
    verdict = audit.judge_npm_audit(Outcome(1, refused, "npm error audit endpoint returned an error"))
    assert (verdict.code, _UNREACHED in verdict.lines[0]) == (0, True)


def test_an_audit_that_breaks_fails_with_its_own_code():
    verdict = audit.judge_pip_audit(Outcome(2, "", "usage: pip-audit"))
    assert verdict == audit.Verdict(("pip-audit failed:", "usage: pip-audit"), 2)
    assert audit.judge_npm_audit(Outcome(0, "", "")).code == 1


def test_an_advisory_for_a_package_of_npm_fails():
    sick = {"svelte": {"severity": "high", "range": "<5.1"}}
    verdict = audit.judge_npm_audit(Outcome(1, json.dumps({"auditReportVersion": 2, "vulnerabilities": sick}), ""))
    assert verdict == audit.Verdict(("npm audit: 1 packages with advisories", "  svelte: high, <5.1"), 1)
    clean = json.dumps({"auditReportVersion": 2, "vulnerabilities": {}})
    assert audit.judge_npm_audit(Outcome(0, clean, "")).code == 0
