// Which panel is open beside everything else.

export type DialogName =
  | 'bookings'
  | 'buttons'
  | 'connect'
  | 'help'
  | 'holding'
  | 'icon'
  | 'insert'
  | 'job'
  | 'keep'
  | 'newApplication'
  | 'newModule'
  | 'bringBack'
  | 'open'
  | 'own'
  | 'preferences'
  | 'recordings'
  | 'redirect'
  | 'remote'
  | 'saveAs'
  | 'saveGroup'
  | 'scope'
  | 'sets'
  | 'sheet'
  | 'source'
  | 'target'
  | 'unit'
  | 'whatIf'

/** The panel that is open, and what it is about. */
export interface Dialog {
  /** Empty: none is open. */
  name: DialogName | ''
  data: Record<string, string>
}

export const dialogs: { current: Dialog; isPaletteOpen: boolean } = $state({
  current: { name: '', data: {} },
  isPaletteOpen: false,
})

export function openDialog(name: DialogName, data: Record<string, string> = {}): void {
  dialogs.current = { name, data }
}

export function closeDialog(): void {
  dialogs.current = { name: '', data: {} }
}

/**
 * What closes the panel that is open now, for whoever waits for an answer: another that was opened meanwhile stays. It
 * tells whether this one was still there.
 */
export function closingThisOne(): () => boolean {
  const opened = dialogs.current
  return () => {
    const isOpen = dialogs.current === opened
    if (isOpen) closeDialog()
    return isOpen
  }
}
