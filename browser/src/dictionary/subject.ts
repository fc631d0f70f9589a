// What the icon panel is about: a step of the application shown, or an icon of a dictionary.
import type { EditIcon, EditOnikon, OnikonView, StepView } from '../api.gen'
import { desk } from '../link/desk.svelte'
import { workspace } from '../state/workspace.svelte'

export interface Subject {
  readonly name: string
  readonly one: StepView | OnikonView
  /** The application it stands in; empty: a dictionary. */
  readonly application: string
  /** Whether it is locked, because its application runs (D18). */
  readonly isRunning: boolean
}

/** Undefined where it is not there, or not any more. */
export function subjectOf({ step, onikon, doc }: Record<string, string>): Subject | undefined {
  if (step !== undefined) return stepOf(doc || workspace.app, step)
  const view = desk.tree.onikons[onikon ?? '']
  return view && onikon ? { name: onikon, one: view, application: '', isRunning: false } : undefined
}

/** What tells it from others, for what is begun of it and not saved. */
export const keyOf = ({ step, onikon, doc }: Record<string, string>): string =>
  step !== undefined ? `step ${doc || workspace.app} ${step}` : `onikon ${onikon}`

/** What it says and shows, in one word: another one tells that somebody has changed it meanwhile. */
export const contentOf = ({ description, words, values, picture }: Subject['one']): string =>
  JSON.stringify([description, words, values, picture])

function stepOf(doc: string, number: string): Subject | undefined {
  const app = desk.tree.applications[doc]
  const view = app?.steps?.[number]
  if (!app || !view || (view.kind ?? 'icon') !== 'icon') return undefined
  return { name: view.name ?? '', one: view, application: app.name, isRunning: app.is_running === true }
}

export interface Changes {
  description?: string
  values?: string[][]
  picture?: string
}

/** The act that changes it; what is left out stays. */
export function changing(data: Record<string, string>, changes: Changes): EditIcon | EditOnikon {
  if (data.step !== undefined)
    return { t: 'EditIcon', doc: data.doc || workspace.app, step: Number(data.step), ...changes }
  return { t: 'EditOnikon', onikon: data.onikon ?? '', ...changes }
}
