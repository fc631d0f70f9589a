// What a first page offers: the configurations that show most, then whatever there is; and an application.
import type { ApplicationFile, ConfigurationFile } from '../api.gen'
import type { TextKey } from '../texts/index.svelte'

/** What is said of those that come with the laboratories, in the order they are offered. */
const KNOWN: Readonly<Record<string, TextKey>> = {
  jmoveC: 'canvas.example.jmove',
  cmoveC: 'canvas.example.cmove',
  opengripC: 'canvas.example.opengrip',
}
const ORDER = Object.keys(KNOWN)

export interface Example {
  file: ConfigurationFile
  about: TextKey | undefined
}

export function examples(files: Readonly<Record<string, ConfigurationFile>>, most = 3): Example[] {
  const place = ({ name }: ConfigurationFile): number => (ORDER.includes(name) ? ORDER.indexOf(name) : ORDER.length)
  return Object.values(files)
    .sort((a, b) => place(a) - place(b) || (b.tasks ?? 0) - (a.tasks ?? 0) || (a.name < b.name ? -1 : 1))
    .slice(0, most)
    .map((file) => ({ file, about: KNOWN[file.name] }))
}

/** The application that shows most: the assembly of the boxes; where it is not there, none. */
export function application(files: Readonly<Record<string, ApplicationFile>>): ApplicationFile | undefined {
  return Object.values(files).find((file) => file.name === 'assemble')
}
