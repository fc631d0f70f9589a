// Small words of a run: flows, seconds, actions, in the language of this browser.
import type { ApplicationView, FlowRunView, RunView } from '../api.gen'
import { look } from '../state/look.svelte'
import { t } from '../texts/index.svelte'
import { actionTexts } from './actionTexts.svelte'

export const flowName = (order: number): string => t('perform.flow', { n: order })

/** The name of a subsystem's flow; of a nested one the subsystem's own. */
export function nameOf(run: RunView, subsystem: string): string {
  const flow = run.flows?.[subsystem]
  return flow && !flow.is_nested ? flowName(flow.order) : subsystem
}

/** Whether there is more than one flow to tell apart. */
export const isSeveral = (run: RunView): boolean =>
  Object.values(run.flows ?? {}).filter((flow) => !flow.is_nested).length > 1

const formats = new Map<string, Intl.NumberFormat>()

/** Seconds with one place, as they are said in this language; a thousand icons say them, so that each form is made once. */
export function seconds(value: number, places = 1): string {
  const key = `${look.language} ${places}`
  let form = formats.get(key)
  if (!form) {
    form = new Intl.NumberFormat(look.language, {
      minimumFractionDigits: places,
      maximumFractionDigits: places,
      useGrouping: false,
    })
    formats.set(key, form)
  }
  return form.format(value)
}

/** As `00:08.8`, or `1:02:03.4`. */
export function clockText(at_s: number): string {
  const tenths = Math.max(0, Math.floor(at_s * 10 + 1e-6))
  const [hours, minutes, rest] = [Math.floor(tenths / 36000), Math.floor(tenths / 600) % 60, tenths % 600]
  const two = (n: number): string => String(n).padStart(2, '0')
  return `${hours ? `${hours}:` : ''}${two(minutes)}:${two(Math.floor(rest / 10))}.${rest % 10}`
}

/** What an action of the application that runs is about, by any of its steps. */
export const actionOf = (step: number): string => actionTexts.of(step)

/** What a flow carries out, in short; what it waits for is told elsewhere. */
export function doing(flow: FlowRunView, step = flow.step ?? 0): string {
  const within = flow.within?.at(-1)
  const action = flow.action ?? ''
  return action && within ? `${action} ${t('perform.within', { name: within })}` : actionOf(step) || action
}

/** The names of flows as a list: "Flow 0 and Flow 1". */
export const listed = (names: readonly string[]): string => new Intl.ListFormat(look.language).format(names)

/** The pictures of an action: of its icon and of its targets. */
export function picturesOf(app: ApplicationView | undefined, steps: readonly number[]): string[] {
  return steps.flatMap((step) => app?.steps?.[step]?.picture ?? [])
}
