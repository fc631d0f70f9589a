// A message as the environment sends it. A reason that says nothing becomes the empty text, so that what is asked is
// only whether there is something to say.
import type { AnyMessage } from '../api.gen'

const NOTHING = '{"key":"","text":""'

/** The message of these words; most hold no empty reason, and cost no second look. */
export function message(words: string): AnyMessage {
  if (!words.includes(NOTHING)) return JSON.parse(words) as AnyMessage
  return JSON.parse(words, (_key, value: unknown) => (saysNothing(value) ? '' : value)) as AnyMessage
}

function saysNothing(value: unknown): boolean {
  if (typeof value !== 'object' || value === null) return false
  const reason = value as { key?: unknown; text?: unknown }
  return reason.key === '' && reason.text === ''
}
