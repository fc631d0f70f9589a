// What the palette offers, and how it is searched.
import { allCommands, isAvailable } from '../state/commands'
import { desk } from '../link/desk.svelte'
import { reveal } from '../act/reveal.svelte'
import { canvas, pick } from '../state/canvas.svelte'
import { look } from '../state/look.svelte'
import { t } from '../texts/index.svelte'
import { open } from '../act/opening'

export interface Entry {
  id: string
  kind: string
  label: string
  note?: string
  keys?: string
  /** Found by these words, too, without showing them. */
  also?: string
  /** Whether its label is the name of something rather than words. */
  isName?: boolean
  run: () => unknown
}

export function entries(): Entry[] {
  const level = look.level === 'applications' ? [...onikons()] : [...placed(), ...tasks(), ...variables()]
  return [...commands(), ...level, ...applications(), ...files()]
}

const commands = (): Entry[] =>
  allCommands()
    .filter((command) => command.id !== 'view.palette' && isAvailable(command))
    .map((command) => ({
      id: `c ${command.id}`,
      kind: t('palette.command'),
      label: command.title(),
      run: command.run,
      ...(command.also ? { also: command.also() } : {}),
      ...(command.keys?.[0] ? { keys: command.keys[0] } : {}),
    }))

const placed = (): Entry[] =>
  Object.keys(desk.tree.documents[canvas.doc]?.tasks ?? {}).map((name) => ({
    id: `p ${name}`,
    kind: t('palette.placed'),
    label: name,
    isName: true,
    run: () => reveal({ t: 'ShowTask', task: name }),
  }))

const tasks = (): Entry[] =>
  Object.values(desk.tree.tasks).map((task) => ({
    id: `t ${task.name}`,
    kind: t('palette.task'),
    label: task.name,
    note: task.description,
    isName: true,
    run: () => {
      pick()
      reveal({ t: 'ShowLibraryTask', task: task.name })
    },
  }))

const onikons = (): Entry[] =>
  Object.entries(desk.tree.onikons).map(([name, onikon]) => ({
    id: `o ${name}`,
    kind: t('palette.onikon'),
    label: onikon.words?.[look.language] ?? (onikon.description || name),
    note: name,
    run: () => reveal({ t: 'ShowOnikon', onikon: name }),
  }))

const applications = (): Entry[] =>
  Object.values(desk.tree.application_files).map((file) => ({
    id: `a ${file.path}`,
    kind: t('palette.application'),
    label: file.name,
    note: file.base.split('/').at(-1) ?? '',
    isName: true,
    run: () => open(file.path),
  }))

const files = (): Entry[] =>
  (look.isUpperOnly ? [] : Object.values(desk.tree.files)).map((file) => ({
    id: `f ${file.path}`,
    kind: t('palette.file'),
    label: file.name,
    note: file.base.split('/').at(-1) ?? '',
    isName: true,
    run: () => open(file.path),
  }))

const variables = (): Entry[] =>
  Object.keys(desk.tree.documents[canvas.doc]?.loci ?? {}).map((name) => ({
    id: `v ${name}`,
    kind: t('palette.variable'),
    label: name,
    isName: true,
    run: () => reveal({ t: 'ShowLocus', svar: name }),
  }))

/** All words must occur; whatever begins with them comes first, then what has them in its label. */
export function find(all: readonly Entry[], wanted: string): Entry[] {
  const words = wanted.toLowerCase().split(/\s+/).filter(Boolean)
  const rated = all.map((entry, k) => ({ entry, k, rank: rank(entry, words) })).filter(({ rank }) => rank < NEVER)
  return rated.sort((a, b) => a.rank - b.rank || a.k - b.k).map(({ entry }) => entry)
}

const NEVER = 9

function rank(entry: Entry, words: readonly string[]): number {
  const label = entry.label.toLowerCase()
  const rest = `${label} ${entry.kind} ${entry.note ?? ''} ${entry.also ?? ''}`.toLowerCase()
  if (!words.every((word) => rest.includes(word))) return NEVER
  const [first = ''] = words
  if (label === words.join(' ')) return 0
  if (label.startsWith(first)) return 1
  return words.every((word) => label.includes(word)) ? 2 : 3
}
