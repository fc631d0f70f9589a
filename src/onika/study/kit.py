"""The kit of a study: a folder with all papers in both languages, and places for logs and answers (§E.1; H05)."""

from html import escape
from pathlib import Path

from onika.study.folder import LOGS, QUESTIONNAIRES
from onika.study.questionnaire import SCALES, STATEMENTS
from onika.study.table import SUBJECT, written
from onika.words.sentence import LANGUAGES

PAPERS = "papers"
_TEXTS = Path(__file__).with_name("papers")
_STYLE = """
:root{color-scheme:light dark}
body{font:12pt/1.45 "Noto Sans","DejaVu Sans",system-ui,sans-serif;max-width:46em;margin:2em auto;padding:0 1.5em;
background:light-dark(#fff,#17191b);color:light-dark(#111,#ece9e2)}
h1{font-size:20pt;margin:0 0 .5em}h2{font-size:13pt;margin:1.2em 0 .3em}p{margin:.5em 0}li{margin:.3em 0}
.field{border-bottom:1px solid;padding-top:.9em;break-inside:avoid}.tall{min-height:9em}
.boxes{list-style:none;padding-left:1.6em}.boxes li::before{content:"☐";margin-left:-1.4em;margin-right:.4em}
table{border-collapse:collapse;width:100%;margin:.6em 0;break-inside:avoid}
th,td{border:1px solid;padding:.35em .5em;text-align:left;height:1.6em}
.scale :is(th,td):nth-child(n+3){text-align:center;width:2.2em}.scale td:first-child{width:2em}
.load td{border:0;border-bottom:1px solid;padding:0;text-align:center;height:1em}
.ends{display:flex;justify-content:space-between;font-size:10pt;margin:0}
.stack{width:14em}.stack td{text-align:center;height:2.6em}
@media print{:root{color-scheme:light}body{margin:0;padding:0;max-width:none;font-size:11pt;line-height:1.35}
h2{break-after:avoid;margin-top:.8em}@page{size:A4;margin:16mm 18mm}}
"""


def papers(language: str) -> dict[str, str]:
    """The papers of a language as HTML files that need nothing else, by their names."""
    return {
        path.name: _page(path.read_text(encoding="utf-8"), language)
        for path in sorted((_TEXTS / language).glob("*.html"))
    }


def files() -> dict[str, str]:
    """All files of a kit by their places in its folder."""
    kit = {f"{PAPERS}/{language}/{name}": text for language in LANGUAGES for name, text in papers(language).items()}
    return {**kit, QUESTIONNAIRES: written(_columns(), [])}


def create(folder: Path) -> list[Path]:
    """Make the folder; raises FileExistsError where it is there already, OSError where it cannot be made."""
    folder.mkdir(parents=True)
    (folder / LOGS).mkdir()
    paths = []
    for name, text in files().items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
        paths.append(path)
    return paths


def _columns() -> tuple[str, ...]:
    return SUBJECT, *(f"sus{number}" for number in range(1, STATEMENTS + 1)), *SCALES


def _page(body: str, language: str) -> str:
    title = body[body.index("<h1>") + 4 : body.index("</h1>")]
    return (
        f'<!doctype html><html lang="{language}"><head><meta charset="utf-8"><title>{escape(title)}</title>'
        f'<meta name="viewport" content="width=device-width"><style>{_STYLE}</style></head>\n'
        f"<body>\n{body}</body></html>\n"
    )
