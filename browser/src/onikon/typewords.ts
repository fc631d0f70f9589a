// The titles of types. Their names come from the syntax file; only the word for what they are is ours.
import type { TypeView } from '../api.gen'
import { t } from '../texts/index.svelte'

const KINDS = ['job', 'application', 'target', 'nop'] as const
type Kind = (typeof KINDS)[number]

/** `Joint object` as the title of a group: Joint targets. */
export function groupTitle(type: string, role: TypeView['role'] | undefined): string {
  const kind = KINDS.find((name) => name === role)
  const stem = type.replace(/\s*\S+$/, '')
  if (!kind || !stem) return type
  if (isComplete(stem)) return t(`dictionary.group.complete.${kind}`)
  return t(`dictionary.group.${kind}`, { kind: stem })
}

/** `Joint object` as one thing: Joint target. */
export function typeTitle(type: string, role: TypeView['role'] | undefined): string {
  const kind: Kind | undefined = KINDS.find((name) => name === role)
  const stem = type.replace(/\s*\S+$/, '')
  if (!kind || !stem) return type
  if (isComplete(stem)) return t(`dictionary.type.complete.${kind}`)
  return t(`dictionary.type.${kind}`, { kind: stem })
}

const isComplete = (stem: string): boolean => stem.toLowerCase() === 'complete'
