// What a task asks, as rows of a form, and the argument line that answers it. The task itself judges the answer again;
// what is said here while somebody types only spares the way.
import type { AskItem, AskView } from '../api.gen'

export interface Field {
  item: AskItem
  index: number
  low: number
  high: number
  /** Both bounds are finite: a slider makes sense. */
  isBounded: boolean
  /** What "take the present position" would fill in. */
  present?: number
}

/** Why a word is no answer: the key of a sentence, and what stands in it. */
export interface Complaint {
  key:
    'ask.empty' | 'ask.word' | 'ask.character' | 'ask.number' | 'ask.finite' | 'ask.whole' | 'ask.below' | 'ask.above'
  found: string
  bound: string
}

/** What binary numbers leave beside round ones. */
const DUST = 1e-9
const NUMBER = /^[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?$/
const ENDLESS = /^[+-]?(inf|infinity|nan)$/i
const WHOLE: Record<string, readonly [number, number]> = {
  byte: [0, 255],
  short: [-(2 ** 15), 2 ** 15 - 1],
  int: [-(2 ** 31), 2 ** 31 - 1],
  long: [-(2 ** 63), 2 ** 63],
}

export function fields(ask: AskView): Field[] {
  return ask.items.flatMap((item) =>
    Array.from({ length: item.count }, (_, index) => {
      const low = item.low?.[index] ?? -Infinity
      const high = item.high?.[index] ?? Infinity
      const isBounded = isNumber(item.type) && Number.isFinite(low) && Number.isFinite(high) && low < high
      return { item, index, low, high, isBounded, present: ask.present?.[item.name]?.[index] }
    }),
  )
}

/** The range in short, as `−2.792 … 2.792`: rounded inwards, so that what is shown is allowed. Empty where there is none. */
export function ends({ low, high }: Field): string {
  if (!Number.isFinite(low) && !Number.isFinite(high)) return ''
  return `${short(low, (v) => Math.ceil(v - DUST))} … ${short(high, (v) => Math.floor(v + DUST))}`.trim()
}

function short(bound: number, round: (value: number) => number): string {
  if (!Number.isFinite(bound)) return ''
  const inwards = round(bound * 1000) / 1000
  return String(Math.abs(bound) < 0.01 ? bound : inwards).replace('-', '−')
}

export const isNumber = (type: string): boolean => isReal(type) || type in WHOLE
const isReal = (type: string): boolean => type === 'float' || type === 'double'

/** The word that a field begins with. */
export function first(field: Field): string {
  const value = field.item.default?.[field.index]
  return value === undefined || value === null ? '' : String(value)
}

/** What is wrong with a word; undefined: nothing. */
export function complaint(field: Field, typed: string): Complaint | undefined {
  const { type } = field.item
  const text = isNumber(type) ? typed.trim() : typed
  const say = (key: Complaint['key'], bound = ''): Complaint => ({ key, found: text, bound })
  if (type === 'char') return [...text].length === 1 ? undefined : say(text ? 'ask.character' : 'ask.empty')
  if (!isNumber(type)) return type === 'string' && /\s/.test(text) ? say('ask.word') : undefined
  if (!text) return say('ask.empty')
  if (isReal(type) && ENDLESS.test(text)) return say('ask.finite')
  if (!NUMBER.test(text)) return say(isReal(type) ? 'ask.number' : 'ask.whole')
  if (!isReal(type) && !/^[+-]?\d+$/.test(text)) return say('ask.whole')
  return outside(field, Number(text), say)
}

function outside(field: Field, value: number, say: (key: Complaint['key'], bound: string) => Complaint) {
  const [least, most] = WHOLE[field.item.type] ?? [-Infinity, Infinity]
  const low = Math.max(field.low, least)
  const high = Math.min(field.high, most)
  if (!Number.isFinite(value)) return say('ask.finite', '')
  if (value < low) return say('ask.below', String(low))
  return value > high ? say('ask.above', String(high)) : undefined
}

/** The argument line of these words: those that are empty or hold blanks or quotes stand in double quotes. */
export function line(words: readonly string[]): string {
  return words.map((word) => (word && !/[\s"]/.test(word) ? word : `"${word.replace(/[\\"]/g, '\\$&')}"`)).join(' ')
}

const PASTED = /"(?:\\.|[^"\\])*"|[^\s;]+/g

/**
 * The words of a pasted line, one for each field from the one on it was pasted into; undefined: it is one word, or belongs
 * into a field that takes a whole line. Between numbers may stand blanks, commas or semicolons, around them brackets.
 */
export function pasted(text: string, row: Field): string[] | undefined {
  if (row.item.type === 'line') return undefined
  const hasGaps = /[\s;]/.test(text.trim())
  const isList = hasGaps || (text.match(/,/g) ?? []).length > 1 || /^\s*\[.*,.*\]\s*$/.test(text)
  if (!isList) return undefined
  const spaced = hasGaps ? text : text.replaceAll(',', ' ')
  const words = (spaced.replace(/[[\](){}]/g, ' ').match(PASTED) ?? []).map((word) =>
    word.startsWith('"') ? word.slice(1, -1).replace(/\\(.)/g, '$1') : word.replace(/,$/, '').replace(',', '.'),
  )
  const given = words.filter(Boolean)
  return given.length > 1 ? given : undefined
}

/** What Up and Down make of a number: one step more or less, with Shift ten; undefined: the key or the word is another. */
export function stepped(
  field: Field,
  word: string,
  event: Pick<KeyboardEvent, 'key' | 'shiftKey'>,
): string | undefined {
  const way = { ArrowUp: 1, ArrowDown: -1 }[event.key]
  const value = Number(word)
  if (!way || !isNumber(field.item.type) || !Number.isFinite(value)) return undefined
  const size = (field.isBounded ? step(field) : 1) * (event.shiftKey ? 10 : 1)
  const inside = Math.max(field.low, Math.min(field.high, value + way * size))
  return String(Number(inside.toPrecision(12)))
}

/** The step of a slider and of the arrow keys: a round five-hundredth of its range, one where only whole numbers count. */
export function step(field: Field): number {
  if (!isReal(field.item.type)) return 1
  return 10 ** Math.floor(Math.log10((field.high - field.low) / 200))
}
