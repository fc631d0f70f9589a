"""A console on a terminal: a line is typed at the bottom while what is told goes by above it (requirement A16)."""

import asyncio
import os
import signal
import sys
from collections import deque
from collections.abc import Callable, Mapping
from contextlib import ExitStack
from pathlib import Path
from types import TracebackType
from typing import Any, cast

from prompt_toolkit import PromptSession
from prompt_toolkit.application import Application
from prompt_toolkit.completion import Completion, get_common_complete_suffix
from prompt_toolkit.input.typeahead import clear_typeahead
from prompt_toolkit.key_binding import KeyBindings, KeyPressEvent
from prompt_toolkit.output.vt100 import Vt100_Output
from rich.cells import cell_len

from onika.cli.language import say
from onika.cli.lines.safe_text import safe
from onika.cli.typed_input.line_history import LineHistory
from onika.cli.typed_input.terminal_input import TerminalInput
from onika.desk.console.display import Tone
from onika.words.reason import Reason

_COLOURS = {Tone.HEAD: "1", Tone.GOOD: "32", Tone.DIM: "2", Tone.NOTE: "33", Tone.FAULT: "31", Tone.ASK: "35"}


class _Output(Vt100_Output):
    """Writes in one piece what takes the line away, what is told, and what brings it back, so that nothing flickers."""

    is_held = False

    def flush(self) -> None:
        """Write what there is, unless more is to come."""
        if not self.is_held:
            super().flush()


class Terminal:
    """The line at the bottom is taken away before something is said, and comes back after it; nothing typed is lost.

    The line is edited by prompt_toolkit, whose event loop runs only within `line`: all else is done by who calls.

    `history` is the file of the lines of former consoles; none is kept where it is None or cannot be written.
    """

    is_person = True

    def __init__(self, complete: Callable[[str], list[str]], history: Path | None = None) -> None:
        self._complete = complete
        self._input = TerminalInput(sys.stdin)
        self._output = cast("_Output", _Output.from_pty(sys.stdout, term=os.environ.get("TERM")))
        self._output.enable_cpr = False  # the answer of the terminal would come among the keys
        self._history = LineHistory(history)
        self._session: PromptSession[str] = PromptSession(
            lambda: self._prompt,
            input=self._input,
            output=self._output,
            history=self._history,
            enable_history_search=True,
            complete_while_typing=False,
            key_bindings=self._bindings(),
        )
        self._session.app.before_render += self._is_drawn
        self._prompt = ""
        self._typing: asyncio.Task[str] | None = None
        self._failure: BaseException | None = None
        self._lines: deque[str] = deque()
        """Typed, or pasted several at once, and not handed out yet."""
        self._has_colour = not os.environ.get("NO_COLOR")
        self._open = ExitStack()

    def __enter__(self) -> "Terminal":
        with ExitStack() as stack:
            stack.callback(self._history.keep)
            stack.enter_context(self._input.single_keys())
            self._runner = stack.enter_context(asyncio.Runner())
            self._runner.get_loop().set_exception_handler(self._fails)
            self._open = stack.pop_all()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, fault: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._session.app.erase_when_done = True
        self._open.close()

    def say(self, line: Reason, tone: Tone = Tone.PLAIN) -> None:
        """Show a line above the one that is typed."""
        if self._is_shown:
            self._output.is_held = True
            self._hide()
        colour = _COLOURS.get(tone, "") if self._has_colour else ""
        text = safe(say(line))
        self._output.write_raw((f"\x1b[{colour}m{text}\x1b[0m" if colour else text) + "\n")
        self._output.flush()

    def line(self, prompt: str, timeout_s: float) -> str | None:
        """The next line, None while there is none yet; raises EOFError at the end of the input."""
        if self._lines:
            return self._lines.popleft()
        if prompt != self._prompt:
            self._prompt = prompt
            self._session.app.invalidate()
        line = self._runner.run(self._typed(timeout_s))
        if self._failure is not None:
            failure, self._failure = self._failure, None
            raise failure
        if line is None:
            return None
        self._lines.extend(line.removesuffix("\n").split("\n"))
        return self._lines.popleft()

    def drop(self) -> None:
        """Forget what was typed of this line."""
        self._lines.clear()
        clear_typeahead(self._input)
        self._session.default_buffer.reset()
        if self._is_shown:
            self._hide()
        self._output.is_held = False  # what is said of a stop does not wait for the line
        self._output.flush()

    async def _typed(self, timeout_s: float) -> str | None:
        """What was typed up to Enter; None where that takes longer."""
        if self._typing is None:
            edited = self._session.prompt_async(set_exception_handler=False, handle_sigint=False)
            self._typing = asyncio.create_task(edited)
        await asyncio.wait({self._typing}, timeout=timeout_s)
        if not self._typing.done():
            return None
        typing, self._typing = self._typing, None
        return typing.result()

    @property
    def _is_shown(self) -> bool:
        app = self._session.app
        return app.is_running and app.renderer.last_rendered_screen is not None

    def _hide(self) -> None:
        """Take the line away; it comes back at the next turn of the event loop."""
        self._session.app.renderer.erase()
        self._session.app.invalidate()

    def _is_drawn(self, _app: Application[str]) -> None:
        self._output.is_held = False

    def _fails(self, _loop: asyncio.AbstractEventLoop, context: Mapping[str, Any]) -> None:
        """Keep what a key raised: the link may be lost while it completes a word."""
        self._failure = context.get("exception")

    def _bindings(self) -> KeyBindings:
        bindings = KeyBindings()
        bindings.add("tab")(self._tab)
        bindings.add("c-z")(lambda _event: None)  # who is put aside watches over nothing
        bindings.add("c-c")(lambda _event: signal.raise_signal(signal.SIGINT))  # a terminal with another key for it
        return bindings

    def _tab(self, event: KeyPressEvent) -> None:
        """Complete the word before the cursor as far as that goes; where it does not, show what it may become."""
        document = event.current_buffer.document
        before = document.text_before_cursor
        words = self._complete(before)
        if not words:
            return
        begun = "" if not before or before[-1].isspace() else before.split()[-1]
        rest = get_common_complete_suffix(document, [Completion(word, -len(begun)) for word in words])
        if len(words) == 1 and not words[0].endswith("/"):
            rest += " "
        event.current_buffer.insert_text(rest)
        if not rest:
            for row in _rows(words, self._output.get_size().columns):
                self.say(Reason.plain(row), Tone.DIM)


def _rows(words: list[str], columns: int) -> list[str]:
    """Words side by side, as many as have room."""
    width = max(map(cell_len, words)) + 2
    count = max(columns // width, 1)
    return [
        "".join(word + " " * (width - cell_len(word)) for word in words[start : start + count]).rstrip()
        for start in range(0, len(words), count)
    ]
