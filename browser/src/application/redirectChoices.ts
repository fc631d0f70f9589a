// Who stands for whom in an application, as it is said.
import type { ApplicationView, RedirectView } from '../api.gen'
import { t } from '../texts/index.svelte'
import { flowWord } from './words'

/** A wish in words: `puma → scara`, with its flow where it holds in one only. */
export function choiceText({ old, new: other, flow }: RedirectView): string {
  return flow
    ? t('redirect.wishIn', { old, new: other, flow: flowWord(flow) })
    : t('redirect.wish', { old, new: other })
}

/** Those that mean a task of a flow of the application, by its path; a flow in a branch has those of the flow around it. */
export function choicesIn(app: ApplicationView | undefined, path: string): RedirectView[] {
  const home = homeOf(path)
  return (app?.redirects ?? []).filter(({ homes }) => homes?.includes(home))
}

/** The subsystem of a flow: `1/17/0` lies in flow 1. */
export const homeOf = (path: string): string => `flow${path.split('/')[0] || '0'}`

export const choicesText = (choices: readonly RedirectView[]): string => choices.map(choiceText).join(', ')
