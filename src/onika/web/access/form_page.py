"""A page with one form or a few words, without scripts, in the look of the page and in the language that is wanted."""

from html import escape
from string import Template

from onika.words.reason import Reason, in_language
from onika.words.sentence import LANGUAGES

POLICY = "; ".join(
    (
        "default-src 'none'",
        "style-src 'unsafe-inline'",
        "form-action 'self'",
        "base-uri 'none'",
        "frame-ancestors 'none'",
    )
)
"""Its Content-Security-Policy: it runs nothing, and its form goes to us alone."""

_NAMES = {"en": "English", "es": "Español"}

_PAGE = Template("""<!doctype html>
<html lang="$language">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>$title</title>
<style>
:root { color-scheme: light dark; --ground: light-dark(#ebe8e0, #0f1011); --panel: light-dark(#fffefb, #1d1f22);
  --line: light-dark(#ddd8cc, #303338); --line-2: light-dark(#8d8779, #6b7178); --ink: light-dark(#1a1c1e, #ece9e2);
  --ink-2: light-dark(#4d5155, #bcbdbb); --accent: light-dark(#1c5bc7, #80b1ff);
  --on-accent: light-dark(#ffffff, #0c1422); --field: light-dark(#ffffff, #17191b);
  --error: light-dark(#a83a14, #ff9d77); --error-soft: light-dark(#fbe9e2, #3a2119); }
* { box-sizing: border-box; margin: 0; }
body { min-height: 100vh; display: grid; place-items: center; padding: 24px 16px; background: var(--ground);
  color: var(--ink); font: 15px/1.5 'Inter', 'Segoe UI', -apple-system, Roboto, 'Noto Sans', system-ui, sans-serif; }
main { width: min(360px, 100%); }
.word { display: flex; align-items: center; gap: 10px; margin: 0 0 14px 2px; font-size: 22px; font-weight: 650; }
form { display: grid; gap: 6px; padding: 24px; background: var(--panel); border: 1px solid var(--line);
  border-radius: 10px; box-shadow: 0 1px 2px #0002, 0 8px 28px #0002; }
h1 { font-size: 17px; font-weight: 650; }
.about { color: var(--ink-2); font-size: 13px; margin-bottom: 8px; }
label { font-weight: 600; font-size: 13px; margin-top: 8px; }
input { font: inherit; width: 100%; padding: 9px 11px; color: inherit; background: var(--field);
  border: 1px solid var(--line-2); border-radius: 6px; }
input:focus-visible, button:focus-visible, a:focus-visible { outline: 2px solid var(--accent); outline-offset: 2px; }
button, a.button { display: block; width: 100%; text-align: center; text-decoration: none; font: inherit;
  font-weight: 650; margin-top: 18px; padding: 10px; border: 0; border-radius: 6px;
  background: var(--accent); color: var(--on-accent); cursor: pointer; }
button:hover { filter: brightness(1.08); }
.wrong { padding: 9px 11px; margin: 4px 0; border-radius: 6px; border-left: 4px solid var(--error);
  background: var(--error-soft); color: var(--error); font-size: 13.5px; font-weight: 600; }
footer { display: flex; gap: 14px; justify-content: center; margin-top: 16px; font-size: 13px; }
footer a { color: var(--ink-2); } footer b { font-weight: 600; }
</style>
</head>
<body>
<main>
<p class="word"><svg width="26" height="26" viewBox="0 0 20 20" aria-hidden="true"><path
 d="M1 2h10v4l5 1.5v5L11 14v4H1z" fill="currentColor"/><circle cx="6" cy="10" r="2.4" fill="var(--ground)"/></svg>
Onika</p>
$body
<footer>$languages</footer>
</main>
</body>
</html>
""")


def form_page(language: str, title: str, body: str) -> str:
    """The HTML of a page around a body; the title is the key of a sentence."""
    return _PAGE.substitute(
        language=language,
        title=words(title, language),
        body=body,
        languages=" ".join(_link(each, is_shown=each == language) for each in LANGUAGES),
    )


def words(key: str, language: str) -> str:
    """A sentence without gaps, as HTML has it."""
    return escape(in_language(Reason.of(key), language))


def alert(wrong: Reason, language: str) -> str:
    """Why it was not done, as HTML; nothing where nothing is wrong."""
    return f'<p class="wrong" role="alert">{escape(in_language(wrong, language))}</p>' if wrong else ""


def _link(language: str, *, is_shown: bool) -> str:
    name = _NAMES[language]
    return f"<b>{name}</b>" if is_shown else f'<a href="/?lang={language}" lang="{language}">{name}</a>'
