! Displacement and body force of a ring at three points: for each a line with X, u and b.
! The interfaces below are all of mpmvv_mms.h that it needs; the others go the same way.
module mpmvv_mms
  use, intrinsic :: iso_c_binding
  implicit none

  interface
    function mpmvv_create(name, count, parameter_names, parameter_values, solution) bind(c) result(status)
      import :: c_char, c_int, c_ptr, c_double
      character(kind=c_char), intent(in) :: name(*)
      integer(c_int), value :: count
      type(c_ptr), intent(in) :: parameter_names(*)
      real(c_double), intent(in) :: parameter_values(*)
      type(c_ptr), intent(out) :: solution
      integer(c_int) :: status
    end function

    function mpmvv_displacement(solution, n, X, t, u) bind(c) result(status)
      import :: c_ptr, c_size_t, c_double, c_int
      type(c_ptr), value :: solution
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: X(*)
      real(c_double), value :: t
      real(c_double), intent(out) :: u(*)
      integer(c_int) :: status
    end function

    function mpmvv_body_force(solution, n, X, t, b) bind(c) result(status)
      import :: c_ptr, c_size_t, c_double, c_int
      type(c_ptr), value :: solution
      integer(c_size_t), value :: n
      real(c_double), intent(in) :: X(*)
      real(c_double), value :: t
      real(c_double), intent(out) :: b(*)
      integer(c_int) :: status
    end function

    subroutine mpmvv_destroy(solution) bind(c)
      import :: c_ptr
      type(c_ptr), value :: solution
    end subroutine
  end interface
end module

program ring
  use mpmvv_mms
  implicit none
  character(kind=c_char, len=16), target :: names(2)
  real(c_double) :: values(2) = [0.05d0, 0.3d0]
  real(c_double) :: X(2, 3) = reshape([0.6d0, 0.0d0, 0.3d0, 0.7d0, -0.5d0, -0.5d0], [2, 3])
  real(c_double) :: u(2, 3), b(2, 3)
  real(c_double), parameter :: t = 0.004d0
  type(c_ptr) :: solution
  integer :: p

  names(1) = "amplitude" // c_null_char
  names(2) = "poissons_ratio" // c_null_char
  if (mpmvv_create("ring" // c_null_char, 2, [c_loc(names(1)), c_loc(names(2))], values, solution) /= 0) stop 1
  if (mpmvv_displacement(solution, 3_c_size_t, X, t, u) /= 0) stop 1
  if (mpmvv_body_force(solution, 3_c_size_t, X, t, b) /= 0) stop 1
  do p = 1, 3
    print "(6es26.17)", X(:, p), u(:, p), b(:, p)
  end do
  call mpmvv_destroy(solution)
end program
