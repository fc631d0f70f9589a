"""The page of a study: what is wrong, groups compared, questionnaires, subjects, timelines (requirements H02, H03)."""

from collections.abc import Callable, Iterator
from html import escape

from onika.study.compared import ComparedFigure
from onika.study.folder import Study
from onika.study.report import comparison_section, markup, questionnaire_section, subject_section
from onika.study.report.style import STYLE
from onika.words.reason import Reason

Say = Callable[[Reason], str]


def page(study: Study, compared: tuple[ComparedFigure, ...], say: Say, language: str) -> str:
    """The page as one HTML file without anything outside it."""
    title = say(Reason.of("study.title", name=study.name))
    policy = "default-src 'none'; style-src 'unsafe-inline'"
    head = (
        f'<!doctype html><html lang="{language}"><head><meta charset="utf-8"><title>{escape(title)}</title>'
        '<meta name="viewport" content="width=device-width">'
        f'<meta http-equiv="Content-Security-Policy" content="{policy}"><style>{STYLE}</style></head><body>'
    )
    return head + "\n".join(_body(study, compared, say, title)) + "</body></html>\n"


def _body(study: Study, compared: tuple[ComparedFigure, ...], say: Say, title: str) -> Iterator[str]:
    subjects = study.subjects
    counted = sum(subject.is_compared for subject in subjects)
    yield markup.heading(1, title)
    yield markup.paragraph(say(Reason.of("study.counted", count=len(subjects), compared=counted)), "dim")
    yield from _faults(study, say)
    yield markup.heading(2, say(Reason.of("study.groups_head")))
    yield markup.paragraph(say(Reason.of("study.groups_text")))
    if not compared:
        yield markup.paragraph(say(Reason.of("study.nothing_compared")))
    if len(compared) > 1:
        yield markup.paragraph(say(Reason.of("study.several_figures", count=len(compared))), "dim")
    for figure in compared:
        yield from comparison_section.section(figure, say)
    if compared:
        yield markup.heading(2, say(Reason.of("study.power_head")))
        yield comparison_section.needed(compared[0].comparison, say)
    yield from questionnaire_section.section(study, say)
    yield markup.heading(2, say(Reason.of("study.subjects_head")))
    yield subject_section.overview(subjects, say)
    if any(subject.selections for subject in subjects):
        yield markup.heading(2, say(Reason.of("study.icons_head")))
        yield subject_section.icons(subjects, say)
    if any(subject.task for subject in subjects):
        yield markup.heading(2, say(Reason.of("study.timelines_head")))
        yield markup.paragraph(say(Reason.of("study.timelines_text")), "dim")
        for subject in subjects:
            yield from subject_section.single(subject, say)


def _faults(study: Study, say: Say) -> Iterator[str]:
    wrong = [say(fault.sentence) for fault in study.faults if not fault.is_note]
    notes = [say(fault.sentence) for fault in study.faults if fault.is_note]
    if wrong:
        yield markup.heading(2, say(Reason.of("study.faults_head", count=len(wrong))))
        yield markup.listing(wrong)
    if notes:
        yield markup.heading(2, say(Reason.of("study.notes_head")))
        yield markup.listing(notes)
