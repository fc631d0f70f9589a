// Which own changes are sent back to a library of others, and which of them wait for a word of the user.
import type { HeldFileView, OwnChangeView, SentBackView } from '../api.gen'

/** The paths that are sent: all but those that were left out. */
export const toSend = (changes: readonly OwnChangeView[], leftOut: readonly string[]): string[] =>
  changes.map((change) => change.path).filter((path) => !leftOut.includes(path))

/** What is left out, once a path was chosen or not. */
export const left = (leftOut: readonly string[], path: string, isChosen: boolean): readonly string[] =>
  isChosen ? leftOut.filter((other) => other !== path) : [...leftOut, path]

/** What was not sent: where both contradict, or where both were merged. */
export const held = (sent: SentBackView | undefined, contradicts: boolean): readonly HeldFileView[] =>
  (sent?.held ?? []).filter((file) => (file.contradicts ?? false) === contradicts)
