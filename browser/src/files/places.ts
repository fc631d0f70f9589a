// Where a file may be saved: the base directories that are the user's own; what comes with Onika is none of them.
import type { DictionaryView, LibraryView } from '../api.gen'

interface Bases {
  libraries: Readonly<Record<string, LibraryView>>
  dictionaries: Readonly<Record<string, DictionaryView>>
}

/** `own` is where the file lies already, wherever that is; it comes first. */
export function placesOf({ libraries, dictionaries }: Bases, own: string): string[] {
  const open = [...Object.values(libraries), ...Object.values(dictionaries)]
    .filter((library) => !library.is_shipped)
    .map((library) => library.path)
  return [...new Set([...(own ? [own] : []), ...open])]
}
