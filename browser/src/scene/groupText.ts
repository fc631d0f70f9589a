// The state of a supermodule, and of a task, as a word.
import type { DocumentView } from '../api.gen'
import { t } from '../texts/index.svelte'
import { summary } from './groups'
import type { State } from '../widgets/mark'

export const stateWord = (state: State): string => (state ? t(`canvas.state.${state}`) : '')

export function wordOf(doc: DocumentView, group: string): string {
  const { look, on, of } = summary(doc, group)
  return look === 'PARTLY' ? t('canvas.group.partly', { on, of }) : stateWord(look)
}
