// Español: lo que se hizo en una aplicación, como lo dicen Deshacer y Rehacer.
export const esHeardDone: readonly (readonly [RegExp, string])[] = [
  [/^inserting (.+)$/, 'insertar {0}'],
  [/^deleting (.+)$/, 'borrar {=0}'],
  [/^cutting (.+)$/, 'cortar {=0}'],
  [/^pasting (.+)$/, 'pegar {=0}'],
  [/^moving (.+)$/, 'mover {=0}'],
  [/^changing (.+)$/, 'cambiar {0}'],
  [/^(\d+) icons$/, '{0} iconos'],
  [/^setting (\d+) breakpoints$/, 'poner {0} puntos de pausa'],
  [/^removing (\d+) breakpoints$/, 'quitar {0} puntos de pausa'],
  [/^reading the file again$/, 'volver a leer el archivo'],
]
