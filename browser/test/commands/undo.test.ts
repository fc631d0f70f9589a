// R-X10: one key takes back what was done last, to what is shown or to what belongs to no file.
import { expect, test } from 'vitest'
import '../../src/commands/shell'
import { toRedo, toUndo } from '../../src/act/documents.svelte'
import { desk, fullTree } from '../../src/link/desk.svelte'
import { allCommands } from '../../src/state/commands'
import { canvas } from '../../src/state/canvas.svelte'
import { look } from '../../src/state/look.svelte'
import { plain } from '../../src/texts/say'

const command = (id: string) => allCommands().find((one) => one.id === id)!

function show(documents: Parameters<typeof fullTree>[0]): void {
  desk.tree = fullTree(documents)
  look.level = 'tasks'
  canvas.doc = 'd1'
}

test('the keys are those of every program', () => {
  expect(command('edit.undo').keys).toEqual(['Ctrl+Z'])
  expect(command('edit.redo').keys).toEqual(['Ctrl+Shift+Z', 'Ctrl+Y'])
  expect(
    allCommands()
      .filter(({ keys }) => keys?.some((key) => key.endsWith('Z')))
      .map(({ id }) => id),
  ).toEqual(['edit.undo', 'edit.redo'])
})

test('what the environment names of the file that is shown is what is taken back', () => {
  show({
    documents: { d1: { name: 'a', order: 0, undo: plain('changing preferences'), redo: plain('placing pd') } },
    own_undo: plain('changing preferences'),
  })
  expect([toUndo(), toRedo()]).toEqual(['changing preferences', 'placing pd'])
  expect([command('edit.undo').when?.(), command('edit.redo').when?.()]).toEqual([true, true])
})

test('where no file is shown it is what belongs to none', () => {
  show({ own_undo: plain('changing preferences') })
  expect([toUndo(), toRedo()]).toEqual(['changing preferences', ''])
  expect([command('edit.undo').when?.(), command('edit.redo').when?.()]).toEqual([true, false])
})

test('where nothing was done there is nothing to take back', () => {
  show({ documents: { d1: { name: 'a', order: 0 } } })
  expect([toUndo(), toRedo()]).toEqual(['', ''])
  expect(command('edit.undo').when?.()).toBe(false)
})
