import { say, type Reason } from '../texts/say'
// Lines of the log as text.

export interface Spoken {
  level: string
  text: Reason
  doc?: string
  at_s?: number
}

/** The time of day at which the environment said it; all lines have this clock. */
export function clock(at_s: number): string {
  const two = (part: number): string => String(part).padStart(2, '0')
  const at = new Date(at_s * 1000)
  return [at.getHours(), at.getMinutes(), at.getSeconds()].map(two).join(':')
}

/** Lines that hold all the words, in any case. */
export function filtered<L extends Spoken>(lines: readonly L[], words: string): L[] {
  const wanted = words.toLowerCase().split(/\s+/).filter(Boolean)
  return lines.filter((line) => wanted.every((word) => `${line.level} ${say(line.text)}`.toLowerCase().includes(word)))
}

/** As it is copied: time, level, text. */
export function copied(lines: readonly Spoken[]): string {
  return lines.map((line) => `${clock(line.at_s ?? 0)}\t${line.level}\t${say(line.text)}\n`).join('')
}
