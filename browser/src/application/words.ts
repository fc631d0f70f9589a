// How the workspace says what stands in it: for who reads, and for who listens.
import type { ApplicationView, StepView } from '../api.gen'
import { desk } from '../link/desk.svelte'
import { typeTitle } from '../onikon/typewords'
import { wordsOf } from '../onikon/words'
import { faultsAt, isFault } from './faults'
import { say } from '../texts/say'
import { t } from '../texts/index.svelte'
import type { Actions } from './actions'

/** What a step is called. */
export function nameOf(step: StepView | undefined): string {
  if (!step) return ''
  if (step.kind === 'hole') return t('upper.hole', { what: wantedOf(step) })
  if (step.kind === 'branch') return t('upper.branch')
  return wordsOf(step, step.name ?? '')
}

/** What a hole waits for. */
export function wantedOf({ wants = [] }: StepView): string {
  return wants.length
    ? wants.map((type) => typeTitle(type, desk.tree.types[type]?.role)).join(t('upper.or'))
    : t('upper.anAction')
}

/** A step as it is read out: `turn to, above triangle; action 3 of 7, breakpoint`. */
export function readOut(app: ApplicationView, actions: Actions, number: number): string {
  const step = app.steps?.[number]
  if (!step) return ''
  if (step.kind === 'branch') return t('upper.readBranch', { n: step.flows?.length ?? 0 })
  const action = actions.of.get(number)
  const isFirst = action?.steps[0] === number
  const names = isFirst ? action.steps.map((number) => nameOf(app.steps?.[number])) : [nameOf(step)]
  const parts = [names.join(', ')]
  if (isFirst) parts.push(t('upper.readIndex', { index: action.index, of: actions.counts.get(action.flow) ?? 0 }))
  else if (action) parts.push(t('upper.readOf', { name: nameOf(app.steps?.[action.steps[0]!]) }))
  return [parts.join('; '), ...marksOf(step), ...troublesOf(app, number)].join(', ')
}

function marksOf(step: StepView): string[] {
  return [
    step.breaks ? (step.break_if ? t('upper.readBreakIf', { condition: step.break_if }) : t('upper.readBreak')) : '',
    step.synch_tag ? t('upper.readTag', { tag: step.synch_tag }) : '',
    step.loop ? t(step.is_test ? 'upper.readTest' : 'upper.readAnchor', { tag: step.loop }) : '',
  ].filter(Boolean)
}

function troublesOf(app: ApplicationView, number: number): string[] {
  const sentences = faultsAt(app, number).map((fault) =>
    t(isFault(fault) ? 'redirect.readFault' : 'redirect.readWarning', { text: say(fault.text) }),
  )
  return app.steps?.[number]?.note ? [...sentences, t('redirect.readNote')] : sentences
}

/** `1/17/0` is flow 0 of a branch in flow 1. */
export const flowName = (path: string): string => t('upper.flow', { n: path.split('/').at(-1) ?? path })

/** A flow as the runtime calls it: `flow0`, or the name it was given. */
export const flowWord = (name: string): string => name.replace(/^flow(\d+)$/i, (_, n: string) => t('upper.flow', { n }))
