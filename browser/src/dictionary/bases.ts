// The base directories that a target may be kept in: those of the open dictionaries, the user's own before what comes with Onika.
import type { DictionaryView } from '../api.gen'

export function basesOf(dictionaries: readonly DictionaryView[]): DictionaryView[] {
  return [...dictionaries].filter((dictionary) => !dictionary.is_shipped).sort((a, b) => a.order - b.order)
}
