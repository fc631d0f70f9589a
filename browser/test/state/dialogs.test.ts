// D09: a panel whose answer comes late closes itself, and no other one.
import { beforeEach, expect, test } from 'vitest'
import { closeDialog, closingThisOne, dialogs, openDialog } from '../../src/state/dialogs.svelte'

beforeEach(closeDialog)

test('what waits for an answer closes the panel that was open when it asked', () => {
  openDialog('saveAs', { doc: 'a1' })
  const close = closingThisOne()
  expect(close()).toBe(true)
  expect(dialogs.current.name).toBe('')
})

test('a panel that was opened meanwhile stays, also one of the same name', () => {
  openDialog('saveAs', { doc: 'a1' })
  const close = closingThisOne()
  for (const name of ['job', 'saveAs'] as const) {
    openDialog(name, { doc: 'a1' })
    expect(close()).toBe(false)
    expect(dialogs.current.name).toBe(name)
  }
})
