// R-G04: a key means one thing at each level.
import { expect, test } from 'vitest'
import { allCommands } from '../../src/state/commands'
import '../../src/commands/canvas'
import '../../src/commands/dictionary'
import '../../src/commands/perform'
import '../../src/commands/shell'
import '../../src/commands/strip'
import '../../src/commands/upper'
import type { Level } from '../../src/state/look.svelte'

/** Keys that depend on where the keyboard is; each pair of commands says so itself. */
const BY_PLACE = new Set(['/', 'Escape', 'Enter', 'Shift+Enter', 'F2'])

test.each<Level>(['tasks', 'applications'])('at the level of %s no key belongs to two commands', (level) => {
  const owners = new Map<string, string[]>()
  for (const one of allCommands().filter((command) => command.level === undefined || command.level === level))
    for (const keys of one.keys ?? []) owners.set(keys, [...(owners.get(keys) ?? []), one.id])
  expect([...owners].filter(([keys, ids]) => ids.length > 1 && !BY_PLACE.has(keys))).toEqual([])
})

test('what is drawn at one level only has its commands at that level only', () => {
  const of = (group: string): Set<Level | undefined> =>
    new Set(
      allCommands()
        .filter((one) => one.group === group)
        .map((one) => one.level),
    )
  expect([of('canvas'), of('library'), of('dictionary')].map((levels) => [...levels])).toEqual([
    ['tasks'],
    ['tasks'],
    ['applications'],
  ])
})
