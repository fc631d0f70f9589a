// A stop in words: what it is called, and what its choices are called and do.
import type { Remedy, RunView, StopView, Text } from '../api.gen'
import { look } from '../state/look.svelte'
import { t, type TextKey } from '../texts/index.svelte'
import { isSeveral, nameOf } from '../sentences/words'
import { heard } from '../texts/heard'

const KINDS = [
  'error',
  'pressed',
  'tripped',
  'illegal',
  'shutdown',
  'refused',
  'asking',
  'lost',
  'deadlock',
  'deserted',
  'user',
]
const TITLES: Record<string, TextKey> = {
  clear: 'stopped.clear',
  next: 'stopped.next',
  skip: 'stopped.skip',
  pass: 'stopped.pass',
  continue: 'stopped.continue',
  leave: 'stopped.leave',
  abort: 'stopped.abort',
}
const WORDS: Record<string, TextKey> = {
  clear: 'stopped.clearWords',
  next: 'stopped.nextWords',
  skip: 'stopped.skipWords',
  pass: 'stopped.passWords',
  abort: 'stopped.abortWords',
}

export interface Choice {
  /** Its word of steering. */
  verb: string
  title: string
  words: string
  remedy: Remedy
}

export function titleOf(run: RunView, at: string, stop: StopView): string {
  const kind = KINDS.includes(stop.kind) ? stop.kind : 'other'
  const subsystem = stop.subsystem || at
  const flow = subsystem ? nameOf(run, subsystem) : t('stopped.theRun')
  return t(`stopped.title.${kind}` as TextKey, { flow, task: stop.task || t('stopped.aTask') })
}

/** What was said, without where in the module it was said: a module's own error is a sentence for people. */
export function inShort(text: Text): string {
  const sentence = heard(text).replace(/^\w+: (?:ModuleError|LawBroken): /, '')
  return sentence.charAt(0).toUpperCase() + sentence.slice(1)
}

/** The choices in order. What each does is told by whoever knows the run; in other languages by us, more shortly. */
export function choicesOf(run: RunView, stop: StopView): Choice[] {
  return (stop.choices ?? []).map((remedy, k) => {
    const [verb = '', whom = ''] = (remedy.act?.t === 'Steer' ? remedy.act.line : heard(remedy.label)).split(/\s+/)
    const title = TITLES[verb] ? t(TITLES[verb]) : heard(remedy.label)
    const isOther = run.flows?.[whom] !== undefined && whom !== stop.subsystem && isSeveral(run)
    return {
      verb,
      title: isOther ? t('stopped.ofFlow', { what: title, flow: nameOf(run, whom) }) : title,
      words: wordsOf(verb, stop, k),
      remedy,
    }
  })
}

function wordsOf(verb: string, stop: StopView, k: number): string {
  const meaning = stop.meanings?.[k] ?? ''
  const key = WORDS[verb]
  if (key && (look.language !== 'en' || !meaning)) return t(key, { task: stop.task || t('stopped.aTask') })
  return meaning && `${meaning.charAt(0).toUpperCase()}${meaning.slice(1)}${/[.!?]$/.test(meaning) ? '' : '.'}`
}
