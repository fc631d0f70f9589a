// A flow told in sentences: what these are, and as the text that is copied or read out (X11).
import { glue, type Part, plain } from './phrase'
import type { RelationKey } from './relation'

/** The words between descriptions, in one language. */
export interface Connectives {
  code: string
  say(key: SayKey): string
}

export type SayKey =
  | 'say.flow'
  | 'say.byDefault'
  | 'say.onlyNested'
  | 'say.empty'
  | 'say.takes'
  | 'say.takesComma'
  | 'say.and'
  | 'say.nested'
  | 'say.together'
  | 'say.alone'
  | 'say.pause'
  | 'say.pauseIf'
  | 'say.missingTarget'
  | 'say.missingTargetAn'
  | 'say.missingAction'
  | 'say.stray'
  | 'say.loopBottom'
  | 'say.loopTop'
  | 'say.loopBroken'
  | 'say.saysSo'
  | 'say.if'
  | 'say.elseIf'
  | 'say.else'
  | 'say.way'
  | 'say.nothing'
  | 'say.nameless'
  | RelationKey

export interface Sentence {
  kind: 'action' | 'hole' | 'loop' | 'case' | 'note'
  /** Where a click goes; 0: nowhere. */
  step: number
  /** All steps it speaks of. */
  steps: readonly number[]
  /** Which action of the flow it is, from 1; 0: none. */
  number: number
  /** How deep in branches. */
  depth: number
  parts: readonly Part[]
}

/** A flow told. */
export interface Tale {
  path: string
  title: string
  /** When it runs, where that is no matter of course. */
  note: string
  sentences: readonly Sentence[]
}

export const textOf = (sentence: Sentence): string => plain(sentence.parts)

/** All of it as text, as it is copied or read out. */
export function asText(tales: readonly Tale[]): string {
  return tales
    .map(({ title, note, sentences }) => {
      const lines = sentences.map(
        (sentence) =>
          `${'  '.repeat(sentence.depth)}${sentence.number ? `${sentence.number}. ` : ''}${textOf(sentence)}`,
      )
      return [tales.length > 1 ? `${title}${note ? ` – ${note}` : ''}` : '', ...lines].filter(Boolean).join('\n')
    })
    .join('\n\n')
}

/** The text with its number. */
export const fillOne = (text: string, n: string): string => text.replaceAll('{n}', n)

/** A sentence beside the actions, that leads nowhere. */
export const note = (text: string, depth: number): Sentence => ({
  kind: 'note',
  step: 0,
  steps: [],
  number: 0,
  depth,
  parts: glue(text),
})
