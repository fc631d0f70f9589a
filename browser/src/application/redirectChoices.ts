// Who stands for whom in an application, as it is said.
import type { ApplicationView, RedirectView } from '../api.gen'
import { t } from '../texts/index.svelte'
import { flowWord } from './words'

/** A task by its name, a world without its colon. */
const bare = (name: string): string => name.replace(/:$/, '')

/** Who stands for whom, wherever it holds. */
export const standInText = ({ old, new: other }: RedirectView): string =>
  t('redirect.wish', { old: bare(old), new: bare(other) })

/** A wish in words: `puma → scara`, with its flow where it holds in one only. */
export function choiceText(choice: RedirectView): string {
  const { old, new: other, flow } = choice
  return flow ? t('redirect.wishIn', { old: bare(old), new: bare(other), flow: flowWord(flow) }) : standInText(choice)
}

/** Those that mean a task of a flow of the application, by its path; a flow in a branch has those of the flow around it. */
export function choicesIn(app: ApplicationView | undefined, path: string): RedirectView[] {
  const home = homeOf(path)
  return (app?.redirects ?? []).filter(({ homes }) => homes?.includes(home))
}

/** The subsystem of a flow: `1/17/0` lies in flow 1. */
export const homeOf = (path: string): string => `flow${path.split('/')[0] || '0'}`

export const choicesText = (choices: readonly RedirectView[]): string => choices.map(choiceText).join(', ')
