// A stop in words: what it is called, and what its choices are called and do.
import type { AnyAct, RunView, StopView } from '../api.gen'
import { t, type TextKey } from '../texts/index.svelte'
import { isSeveral, nameOf } from '../sentences/words'
import { say } from '../texts/say'

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

/** A choice as it is shown. */
export interface Choice {
  /** Its word of steering. */
  verb: string
  title: string
  meaning: string
  /** Does it; none where it is left open which action is meant. */
  act: AnyAct | null
}

export function titleOf(run: RunView, at: string, stop: StopView): string {
  const kind = KINDS.includes(stop.kind) ? stop.kind : 'other'
  const subsystem = stop.subsystem || at
  const flow = subsystem ? nameOf(run, subsystem) : t('stopped.theRun')
  return t(`stopped.title.${kind}` as TextKey, { flow, task: stop.task || t('stopped.aTask') })
}

/** What was said, without where in the module it was said, as the beginning of a sentence. */
export function inShort(stop: StopView): string {
  return capital(say(stop.short || stop.text))
}

function capital(sentence: string): string {
  return sentence.charAt(0).toUpperCase() + sentence.slice(1)
}

/** What a word of steering is called where it is offered; one that is not known keeps its word. */
export function choiceTitle(verb: string): string {
  const key = TITLES[verb]
  return key ? t(key) : verb
}

/** The choices in order. What each does is told by whoever knows the run. */
export function choicesOf(run: RunView, stop: StopView): Choice[] {
  return (stop.choices ?? []).map(({ verb, subsystem = '', meaning, act = null }) => {
    const title = choiceTitle(verb)
    const isOther = run.flows?.[subsystem] !== undefined && subsystem !== stop.subsystem && isSeveral(run)
    return {
      verb,
      title: isOther ? t('stopped.ofFlow', { what: title, flow: nameOf(run, subsystem) }) : title,
      meaning: withStop(capital(say(meaning))),
      act,
    }
  })
}

/** With the mark at which a sentence ends. */
function withStop(sentence: string): string {
  return sentence && `${sentence}${/[.!?]$/.test(sentence) ? '' : '.'}`
}
