// A message as the environment sends it. A reason that says nothing is left out, so that what is asked is only whether
// there is something to say.
import type { AnyMessage } from '../api.gen'

const NOTHING = '{"key":"","text":""'

/** The message of these words; most hold no empty reason, and cost no second look. */
export function message(words: string): AnyMessage {
  const whole: unknown = JSON.parse(words)
  return (words.includes(NOTHING) ? withoutEmpty(whole) : whole) as AnyMessage
}

/** The same value without reasons that say nothing; what fills the gaps of a reason stays as it is. */
function withoutEmpty(value: unknown): unknown {
  if (Array.isArray(value)) return value.map(withoutEmpty)
  if (typeof value !== 'object' || value === null) return value
  const { key, text } = value as { key?: unknown; text?: unknown }
  if (typeof key === 'string' && typeof text === 'string') return key || text ? value : undefined
  return Object.fromEntries(Object.entries(value).map(([name, part]) => [name, withoutEmpty(part)]))
}
