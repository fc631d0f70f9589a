// The last things said, while they are news.
import { addLine, type Line } from './log.svelte'
import { announce } from '../state/announce'
import type { Say } from '../api.gen'
import { say } from '../texts/say'
import { play } from './sounds'
import { look } from '../state/look.svelte'

const LASTS_MS: Record<Say['level'], number> = { info: 5000, success: 5000, end: 6000, warning: 9000, error: 15_000 }

export const toasts: { lines: Line[] } = $state({ lines: [] })

const NEWS_S = 5

/** Of all that is news: the last thing said, and above it the last that warns or went wrong; all others are in the log. */
export function atOnce<One extends Pick<Line, 'level'>>(lines: readonly One[]): One[] {
  const grave = lines.filter(({ level }) => level === 'error' || level === 'warning').slice(-2)
  const last = lines.at(-1)
  return last && !grave.includes(last) ? [...grave.slice(-1), last] : grave
}

/** Something was said: into the log; and while it is news, if it is not quiet, on the screen, aloud, and as a sound where that is wished. */
export function notify(message: Say): void {
  const line = addLine(message)
  const sentence = say(message.text)
  if (message.is_quiet || line.at_s! < Date.now() / 1000 - NEWS_S) return // from before this page was opened
  toasts.lines = atOnce([...toasts.lines.filter((other) => say(other.text) !== sentence), line])
  announce(sentence)
  if (look.sounds) play(message.level)
  if (message.remedies?.length) return // a choice waits for its user
  setTimeout(() => dismiss(line.id), LASTS_MS[message.level])
}

export function dismiss(id: number): void {
  toasts.lines = toasts.lines.filter((line) => line.id !== id)
}
