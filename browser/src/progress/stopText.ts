// A stop in words: what it is called, and what its choices are called and do.
import type { AnyAct, RunView, StopView } from '../api.gen'
import { t, type TextKey } from '../texts/index.svelte'
import { isSeveral, nameOf } from '../sentences/words'
import { every, say, type Reason } from '../texts/say'

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
/** An input of what moves an arm that would jump. */
const SUDDEN = 'runtime.would_step'
/** What is cleared, by its tasks, and an action that is repeated. */
const REPEATS = 'host.and_repeats'
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
  const subsystem = stop.subsystem || at
  const flow = subsystem ? nameOf(run, subsystem) : t('stopped.theRun')
  const named = { flow, task: stop.task || t('stopped.aTask'), action: stop.action ?? '' }
  return t(`stopped.title.${titleKind(stop)}` as TextKey, named)
}

/** An error is told by what is in the way or by its action; which task has it stands among the details. */
function titleKind(stop: StopView): string {
  if (stop.kind !== 'error') return KINDS.includes(stop.kind) ? stop.kind : 'other'
  if (stop.touches?.length) return 'blocked'
  return stop.action ? 'atAction' : 'error'
}

/** What happened in the words of the program; `isPlain`: tasks and variables are left to the details. */
export function accountOf(stop: StopView): { lines: string[]; isPlain: boolean } {
  const touches = (stop.touches ?? []).map(asSentence)
  const isSudden = every(stop.text).some(({ key }) => key === SUDDEN)
  const isPlain = touches.length > 0 || isSudden
  const what = touches.length ? touches : [isSudden ? t('stopped.tooSudden') : inShort(stop)]
  return { lines: [...what, ...(stop.stands ?? []).map(asSentence)], isPlain }
}

const asSentence = (reason: Reason): string => withStop(capital(say(reason)))

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

/** The choices in order, before the last, the end of the run, to begin anew where that can be. */
export function choicesOf(run: RunView, stop: StopView, canStartOver = false): Choice[] {
  const choices = told(run, stop)
  if (!canStartOver || !choices.length) return choices
  const anew = { verb: 'anew', title: t('stopped.anew'), meaning: t('stopped.anewWords'), act: null }
  return [...choices.slice(0, -1), anew, ...choices.slice(-1)]
}

/** What each does is told by whoever knows the run. */
function told(run: RunView, stop: StopView): Choice[] {
  return (stop.choices ?? []).map(({ verb, subsystem = '', meaning, act = null }) => {
    const title = choiceTitle(verb)
    const isOther = run.flows?.[subsystem] !== undefined && subsystem !== stop.subsystem && isSeveral(run)
    return {
      verb,
      title: isOther ? t('stopped.ofFlow', { what: title, flow: nameOf(run, subsystem) }) : title,
      meaning: withStop(capital(plainMeaning(stop, verb, meaning) ?? say(meaning))),
      act,
    }
  })
}

/** What to try again means where tasks are left to the details; undefined: as whoever knows the run says it. */
function plainMeaning(stop: StopView, verb: string, meaning: Reason): string | undefined {
  if (verb !== 'clear' || !accountOf(stop).isPlain) return undefined
  const repeats = every(meaning).find(({ key }) => key === REPEATS)
  const action = repeats?.args?.action
  return typeof action === 'string' || typeof action === 'object'
    ? t('stopped.repeats', { action: typeof action === 'string' ? action : say(action as Reason) })
    : undefined
}

/** With the mark at which a sentence ends. */
function withStop(sentence: string): string {
  return sentence && `${sentence}${/[.!?]$/.test(sentence) ? '' : '.'}`
}
